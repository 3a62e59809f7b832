#include <nori/parser.h>
// Nuestro main sin ventana
int main(int argc, char **argv) {
    if (argc > 1)
        nori::loadFromXML(argv[1]);
    return 0;
}
