# Copies a text and puts UTF-8's byte order mark before it.
# cmake -DSOURCE=... -DTARGET=... -P WithMark.cmake
string(ASCII 239 187 191 mark)
file(READ "${SOURCE}" text)
file(WRITE "${TARGET}" "${mark}${text}")
