# Copies a module of web/ into the page's folder, which holds all modules, and adapts its imports from other folders.
# Used only without esbuild.
# cmake -DMODULE=... -DTARGET=... -P FlatModule.cmake
file(READ "${MODULE}" text)
string(REGEX REPLACE "from \"\\.\\./[a-z]+/" "from \"./" text "${text}")
file(WRITE "${TARGET}" "${text}")
