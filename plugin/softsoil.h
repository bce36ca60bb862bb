// C interface of softsoil: soft soil under the wheels of a MuJoCo model.
//
// A program that knows nothing of softsoil gets its soil by LD_PRELOAD of libsoftsoil.so. A
// program that links the library calls softsoil_attach() and may ask for results.
//
//   mjModel* m = mj_loadXML("truck.xml", NULL, error, sizeof error);
//   mjData* d = mj_makeData(m);
//   if (softsoil_attach(m, d, NULL)) { puts(softsoil_error()); exit(1); }
//   while (d->time < 10) mj_step(m, d);
//
// Functions that return int return 0, or -1 and a message in softsoil_error(). SI units, world
// axes. A mjData must be used by one thread at a time, as in MuJoCo; different ones in parallel.
//
// If soil fails during a step, the library says so once on stderr, takes its share out of
// xfrc_applied and the simulation goes on without soft soil: softsoil_wheel_count() is -1 from then
// on and softsoil_error() after it tells why. Nothing that is deformed is lost: the ground can
// still be asked, copied and saved, and softsoil_restore(), softsoil_load() and softsoil_reset()
// set the soil going again. In a preloaded program SOFTSOIL_ON_ERROR=stop, which is the default
// there, ends the program instead.
//
// Forces come with MuJoCo's passive forces. A mjcb_passive that the program sets after attaching
// must call the one that was there. With mjDSBL_PASSIVE nothing is asked of the soil, and the last
// force stays in xfrc_applied until softsoil_detach() or softsoil_reset().
#ifndef SOFTSOIL_H_
#define SOFTSOIL_H_

#include <mujoco/mujoco.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define SOFTSOIL_API __attribute__((visibility("default")))
#else
#define SOFTSOIL_API
#endif

// What one wheel does. Axes, signs and definitions: contact/wheel_report.h (TYDEX W axes: x
// forward, y left, z up; forces of the ground on the wheel).
typedef struct softsoilWheel_ {
  const char* name;                      // of the body; lives as long as the soil
  int body;                              // id of the body
  double load;                           // [N]
  double sinkage;                        // [m]
  double rut_depth;                      // [m]
  double slip_ratio;                     // [-]
  double slip_angle;                     // [rad]
  double camber;                         // [rad]
  double spin;                           // [rad/s]
  double forward_speed;                  // [m/s]
  double thrust;                         // [N]
  double motion_resistance;              // [N]
  double drawbar_pull;                   // [N]
  double lateral_force;                  // [N]
  double torque;                         // [N m]
  double contact_area;                   // [m^2]
  double mean_pressure;                  // [Pa]
  double peak_pressure;                  // [Pa]
  double compaction_energy;              // [J]   since the start
  double compaction_power;               // [W]   mean of the last soil period
  double centre[3];                      // [m]   wheel centre
  double force[3], torque_at_centre[3];  // [N], [N m]  of the ground on the wheel, world axes
} softsoilWheel;

// A node of a tire that touches the ground; forces and stresses of the ground on the wheel.
// Definitions: contact/patch_report.h.
typedef struct softsoilContact_ {
  double position[3];      // [m]   of the deformed tire, world axes
  double normal_force[3];  // [N]   from the pressure, world axes
  double shear_force[3];   // [N]   world axes
  double angle;            // [rad] along the circumference from the lowest point of the wheel,
                           //       along the normal of the ground; positive ahead
  double lateral;          // [m]   from the middle plane, positive to the left
  double pressure;         // [Pa]
  double shear;            // [Pa]  along the circumference, positive where it drives forward
  double shear_across;     // [Pa]  across the tread, positive to the left
  double area;             // [m^2]
  double depth;            // [m]   below the undisturbed ground
} softsoilContact;

typedef struct softsoilGround_ {
  const char* soil;     // name in the catalogue, beyond all regions; lives as long as the soil
  double grid_spacing;  // [m]
  double soil_clock;    // [s]
  int threads;
  size_t columns, volumes;  // below touched tiles
  size_t bytes;             // of columns, volumes and surface together
  size_t volume_bytes;      // part of it that grows with the number of volumes
  double rut_volume;        // [m^3]  below the undisturbed ground
  double displaced_volume;  // [m^3]  pressed away by wheels beyond compaction, to elsewhere
  double densified_volume;  // [m^3]  lost, the soil being denser
  double berm_volume;       // [m^3]  above the undisturbed ground
  const char* stress;       // the setting: direct, gaussian or auto
  size_t direct_updates;    // of the soil with load, by where the stress came from, since this
  size_t gaussian_updates;  // soil was made
} softsoilGround;

// Wall time [s] that the soil of a mjData has taken so far, with that of its copies.
typedef struct softsoilProfile_ {
  double contact;     // forces on the wheels and what they leave in the ground
  double flow;        // displaced soil
  double waiting;     // of the step for the soil update
  double stress;      // in the soil update: the stress field
  double compaction;  // in the soil update: densities and heights
} softsoilProfile;

// Version of the library, "0.1.0".
SOFTSOIL_API const char* softsoil_version(void);

// Message of the last call that failed on this thread; "" if none did.
SOFTSOIL_API const char* softsoil_error(void);

// Gives a mjData its soil, as the model's <custom> elements say, and installs mjcb_passive in the
// host. `settings` overrides them, for example "soil=lete_sand clock=0.005"; the keys are those
// of the model without the prefix softsoil_. NULL for none. Fails if the model names no soil.
// Attaching again starts with undisturbed ground.
SOFTSOIL_API int softsoil_attach(const mjModel* m, mjData* d, const char* settings);

// Takes the soil away and its share out of xfrc_applied. Before mj_deleteData.
SOFTSOIL_API int softsoil_detach(const mjModel* m, mjData* d);

// As after attaching: undisturbed ground, our share out of xfrc_applied, results at rest until the
// next step.
SOFTSOIL_API int softsoil_reset(const mjModel* m, mjData* d);

// Number of wheels; -1 if the mjData has no soil, or has lost it.
SOFTSOIL_API int softsoil_wheel_count(const mjData* d);

// Results of the last evaluation of a wheel, 0 to count - 1.
SOFTSOIL_API int softsoil_wheel(const mjData* d, int wheel, softsoilWheel* result);

// Calls visit() for every tire node of a wheel that touched the ground at the last evaluation, in a
// fixed order. None in the air.
typedef void (*softsoilContactVisitor)(void* user, const softsoilContact* contact);
SOFTSOIL_API int softsoil_visit_contacts(const mjData* d, int wheel, softsoilContactVisitor visit,
                                         void* user);

// Height [m] of the surface at x, y [m], each -1e6 to 1e6.
SOFTSOIL_API int softsoil_height(const mjData* d, double x, double y, double* height);

// Size and totals of the ground. Waits for the soil job in flight.
SOFTSOIL_API int softsoil_ground(const mjData* d, softsoilGround* result);

// Where the time went. Unless the soil is updated in place (sync), stress and compaction are done
// in the background, and the step waits only where that is not done in time.
SOFTSOIL_API int softsoil_profile(const mjData* d, softsoilProfile* result);

// Calls visit() for every grid node of the touched ground, in a fixed order.
typedef void (*softsoilVisitor)(void* user, double x, double y, double height, double sinkage);
SOFTSOIL_API int softsoil_visit_surface(const mjData* d, softsoilVisitor visit, void* user);

// Soil as state
//
// The state of the soil is all that its future depends on: the ground, the slip of every tire node,
// the load since the last soil update and the update in flight. mjData has the rest. Only
// softsoil_save_simulation() and softsoil_load_simulation() take care of that too; beside all the
// others it is for you to copy:
//
//   mj_copyData(d2, m, d1);     softsoil_copy(d2, d1);
//   mj_copyData(spare, m, d);   s = softsoil_snapshot(d);
//   mj_copyData(d, m, spare);   softsoil_restore(d, s);
//
// in this order, before the next step. From then on both go on as the one would have, to the bit.
// Ground is shared until one of the two changes it, so copies and snapshots cost next to nothing.
//
// A model with <size nuserdata="2"/> or more needs none of this: the last two numbers of userdata
// hold a mark of the soil state, and a mjData that is copied, restored or reset by whatever means
// finds its soil by itself at the next step, or at a question if it had one before. Each mjData
// keeps its past states while it lives, up to `softsoil_history` [MB]; those that were asked for
// longest ago go first. The mark only names a state: a copy that has not yet stepped finds nothing
// once that state is gone, or the mjData that was there, and that is an error. A HMMWV on a 2.5 cm
// grid with a step of 1 ms takes about 0.11 MB per step, and 0.33 MB where columns compact, so that
// the default of 100 MB reaches back 0.9 s, or 0.3 s. For a longer way back keep a snapshot, which
// takes no more than what has changed since.
//
// Without the mark, mj_resetData and any other way back in time make the ground undisturbed, a
// keyframe of a later time leaves it as it is, and what mj_copyData copies is not the soil. With
// and without, the ground is undisturbed where time alone is set back by hand.

// Gives `dst` the state of the soil of `src`, a mjData of the same model or a copy of it. It gets a
// soil if it has none. Several threads may copy from a `src` that no one uses meanwhile.
SOFTSOIL_API int softsoil_copy(mjData* dst, const mjData* src);

// A state in memory; NULL if that fails. It may outlive the mjData. Restoring does not use it up.
typedef struct softsoilSnapshot_ softsoilSnapshot;
SOFTSOIL_API softsoilSnapshot* softsoil_snapshot(const mjData* d);
SOFTSOIL_API int softsoil_restore(mjData* d, const softsoilSnapshot* snapshot);
SOFTSOIL_API void softsoil_free_snapshot(softsoilSnapshot* snapshot);

// A state in a file, complete or not there. A file of another soil, grid, tire or version is
// refused, and one that is damaged.
SOFTSOIL_API int softsoil_save(const mjData* d, const char* path);
SOFTSOIL_API int softsoil_load(mjData* d, const char* path);

// The same with the state of the mjData itself, for which MuJoCo 2.2 has no function.
// softsoil_load() takes the soil alone from such a file.
SOFTSOIL_API int softsoil_save_simulation(const mjModel* m, const mjData* d, const char* path);
SOFTSOIL_API int softsoil_load_simulation(const mjModel* m, mjData* d, const char* path);

// A number that differs, but for a chance of 2^-64, where states of the soil differ in any bit.
// Waits for the soil job in flight.
SOFTSOIL_API int softsoil_hash(const mjData* d, uint64_t* hash);

#ifdef __cplusplus
}
#endif

#endif  // SOFTSOIL_H_
