// Preloaded beside libsoftsoil.so into a program that knows nothing of either: once per mjData it
// prints what the soil carries, when PROBE_TIME [s] is reached. PROBE_IS_LAST ends the program
// then.
#include <mujoco/mujoco.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "plugin/softsoil.h"

static double probe_time;  // [s]

static void Probe(const mjModel* m, mjData* d) {
  const double half_step = m->opt.timestep / 2;
  if (d->time < probe_time - half_step || d->time >= probe_time + half_step) return;
  double load = 0;
  const int wheels = softsoil_wheel_count(d);
  for (int i = 0; i < wheels; ++i) {
    softsoilWheel wheel;
    if (softsoil_wheel(d, i, &wheel) == 0) load += wheel.load;
  }
  fprintf(stderr, "probe: wheels %d load %.6g weight %.6g contacts %d\n", wheels, load,
          -m->opt.gravity[2] * m->body_subtreemass[0], d->ncon);
  if (getenv("PROBE_IS_LAST") != NULL) _exit(0);
}

__attribute__((constructor)) static void Install(void) {
  const char* time = getenv("PROBE_TIME");
  if (time == NULL) return;
  probe_time = atof(time);
  mjcb_control = Probe;
}
