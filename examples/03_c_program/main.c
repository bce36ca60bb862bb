// Soft soil in a program of one's own: c_program MODEL.xml
#include <softsoil/softsoil.h>
#include <stdio.h>

int main(int argc, char** argv) {
  printf("softsoil %s\n", softsoil_version());
  char error[1000] = "";
  mjModel* m = argc == 2 ? mj_loadXML(argv[1], NULL, error, sizeof error) : NULL;
  if (m == NULL) {
    fprintf(stderr, "usage: c_program MODEL.xml\n%s\n", error);
    return 1;
  }
  mjData* d = mj_makeData(m);
  if (softsoil_attach(m, d, "soil=tilled_yolo_loam") != 0) {
    fprintf(stderr, "%s\n", softsoil_error());
    return 1;
  }
  while (d->time < 1) mj_step(m, d);

  for (int i = 0; i < softsoil_wheel_count(d); ++i) {
    softsoilWheel wheel;
    softsoil_wheel(d, i, &wheel);
    printf("%-12s load %6.1f N, sinkage %4.1f mm\n", wheel.name, wheel.load, 1000 * wheel.sinkage);
  }
  softsoil_detach(m, d);
  mj_deleteData(d);
  mj_deleteModel(m);
  return 0;
}
