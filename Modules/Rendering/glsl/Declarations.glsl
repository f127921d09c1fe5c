// What every program needs. Positions are texture coordinates of the volume, lengths along a ray
// are lengths of the volume's own frame, directions of light and normals are in the world.

uniform sampler3D scene_scalars;
uniform vec3 scene_voxel;          // one voxel in texture coordinates; 0 along an axis with a single one
uniform vec3 scene_boxLow;         // the visible box: first to last voxel centre, cropped
uniform vec3 scene_boxHigh;
uniform mat3 scene_textureToOwn;   // linear parts of the maps to the volume's own frame
uniform mat3 scene_textureToWorld; // and to the world
uniform float scene_sampleDistance;
