#include <softsoil/softsoil.h>
#include <stdio.h>

int main(void) {
  puts(softsoil_version());
  return 0;
}
