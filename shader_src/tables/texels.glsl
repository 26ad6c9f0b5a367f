// Where each baked table lies among the texels that shaders read: eight halves per texel, nodes in
// the order of their axes, what belongs to a node in consecutive texels. The host packs them
// (host/tables/texels.h), and a test holds these numbers to what it packs.
#ifndef LQ_TABLES_TEXELS_GLSL
#define LQ_TABLES_TEXELS_GLSL

// Columns of a texture that holds the texels row after row, from (0, 0) on.
const int LQ_TABLE_COLUMNS = 128;

// Nodes per axis.
const int LQ_TABLE_ALPHAS = 16;
const int LQ_TABLE_ETAS = 16;
const int LQ_T_DOWN_THIN_ETAS = 24;
const int LQ_TABLE_TAUS = 33;
const int LQ_MIRROR_ALPHAS = 24;
const int LQ_LOBE_VARIANCES = 65;
const int LQ_CONDUCTOR_ALPHAS = 16;
const int LQ_CONDUCTOR_INDICES = 24;  // of eta, and as many of kappa
const int LQ_LOBE_NODE_ALPHAS = 24;
const int LQ_LOBE_COSINES = 24;

// Texels per node, where more than one.
const int LQ_T_DOWN_TEXELS = 5;
const int LQ_ABSORPTION_TEXELS = 2;
const int LQ_CONDUCTOR_TERMS = 8;  // of LQ_CONDUCTOR_FACETS: the coefficients of a term each

// The first texel of each array. "Thin" is for eta < 1, "dense" for eta >= 1.
const int LQ_T_DOWN_THIN_BELOW = 0;
const int LQ_T_DOWN_THIN_ABOVE = 1920;
const int LQ_T_DOWN_DENSE_ABOVE = 3840;
const int LQ_ABSORPTION_THIN = 5120;
const int LQ_ABSORPTION_DENSE = 5186;
const int LQ_R_UP_THIN = 5252;
const int LQ_R_UP_DENSE = 5508;
const int LQ_MULTIPLE_THIN_BELOW = 5764;
const int LQ_MULTIPLE_THIN_ABOVE = 6020;
const int LQ_MULTIPLE_DENSE_ABOVE = 6276;
const int LQ_LOBE_ENERGY = 6532;
const int LQ_LOBE_ALPHA = 6556;
const int LQ_CLEAR_THIN_BELOW = 6621;
const int LQ_CLEAR_THIN_ABOVE = 7005;
const int LQ_CLEAR_DENSE_ABOVE = 7389;
const int LQ_CONDUCTOR_FACETS = 7645;
const int LQ_CONDUCTOR_MATERIALS = 7773;
const int LQ_LOBE_NODES = 8349;

#endif
