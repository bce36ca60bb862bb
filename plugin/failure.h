// An error in the middle of a step, on its way out of MuJoCo's callbacks.
#pragma once

#include <exception>

namespace softsoil {

constexpr std::size_t kLongestMessage = 4000;

// Plain memory: the host's error handler may leave by longjmp.
struct Failure {
  bool happened = false;
  char message[kLongestMessage];
};

void Note(const std::exception& error, Failure* failure);

// Ends the program the way its author wants errors to end it: by his handler, mju_user_error, or
// null if he has set none.
void Stop(const Failure& failure, void (*handler)(const char*));

}  // namespace softsoil
