# Copies a module of web/ into the page's folder, where all modules lie side by side: what it imports from another room of
# web/ it then finds beside itself. Only where there is no esbuild to bundle them.
# cmake -DMODULE=... -DTARGET=... -P FlatModule.cmake
file(READ "${MODULE}" text)
string(REGEX REPLACE "from \"\\.\\./[a-z]+/" "from \"./" text "${text}")
file(WRITE "${TARGET}" "${text}")
