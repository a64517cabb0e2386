# Copies the header INPUT to OUTPUT for the public: a header that it includes by its place in the
# sources, "Mesh/TriangleMesh.h", is <DirectionFields/Mesh/TriangleMesh.h> there.
file(READ "${INPUT}" text)
string(REGEX REPLACE "#include \"([^\"]+)\"" "#include <DirectionFields/\\1>" text "${text}")
file(WRITE "${OUTPUT}" "${text}")
