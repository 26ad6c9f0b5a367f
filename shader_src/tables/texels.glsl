// Where each baked table lies among the texels that shaders read: four numbers per texel, nodes in
// the order of their axes, channels of a node in consecutive texels. The host packs them
// (host/tables/texels.h), and a test holds these numbers to what it packs.
#ifndef LQ_TABLES_TEXELS_GLSL
#define LQ_TABLES_TEXELS_GLSL

// Nodes per axis.
const int LQ_TABLE_ALPHAS = 16;
const int LQ_TABLE_ETAS = 16;
const int LQ_T_DOWN_THIN_ETAS = 24;
const int LQ_TABLE_TAUS = 33;
const int LQ_MIRROR_ALPHAS = 24;
const int LQ_LOBE_VARIANCES = 65;

// Texels per node.
const int LQ_T_DOWN_THIN_TEXELS = 8;
const int LQ_T_DOWN_DENSE_TEXELS = 10;
const int LQ_ABSORPTION_TEXELS = 2;
const int LQ_R_UP_TEXELS = 2;
const int LQ_MULTIPLE_TEXELS = 2;

// Nodes over (alpha, eta).
const int LQ_TABLE_NODES = LQ_TABLE_ALPHAS * LQ_TABLE_ETAS;
const int LQ_T_DOWN_THIN_NODES = LQ_TABLE_ALPHAS * LQ_T_DOWN_THIN_ETAS;

// The first texel of each array. "Thin" is for eta < 1, "dense" for eta >= 1.
const int LQ_T_DOWN_THIN_BELOW = 0;
const int LQ_T_DOWN_THIN_ABOVE =
    LQ_T_DOWN_THIN_BELOW + LQ_T_DOWN_THIN_NODES * LQ_T_DOWN_THIN_TEXELS;
const int LQ_T_DOWN_THIN_ABSORPTION =
    LQ_T_DOWN_THIN_ABOVE + LQ_T_DOWN_THIN_NODES * LQ_T_DOWN_THIN_TEXELS;
const int LQ_T_DOWN_DENSE_ABOVE =
    LQ_T_DOWN_THIN_ABSORPTION + LQ_TABLE_TAUS * LQ_ABSORPTION_TEXELS;
const int LQ_T_DOWN_DENSE_ABSORPTION =
    LQ_T_DOWN_DENSE_ABOVE + LQ_TABLE_NODES * LQ_T_DOWN_DENSE_TEXELS;
const int LQ_R_UP_THIN_MAPS = LQ_T_DOWN_DENSE_ABSORPTION + LQ_TABLE_TAUS * LQ_ABSORPTION_TEXELS;
const int LQ_R_UP_THIN_ABSORPTION = LQ_R_UP_THIN_MAPS + LQ_TABLE_NODES * LQ_R_UP_TEXELS;
const int LQ_R_UP_DENSE_MAPS = LQ_R_UP_THIN_ABSORPTION + LQ_TABLE_TAUS * LQ_R_UP_TEXELS;
const int LQ_R_UP_DENSE_ABSORPTION = LQ_R_UP_DENSE_MAPS + LQ_TABLE_NODES * LQ_R_UP_TEXELS;
const int LQ_MULTIPLE_THIN_BELOW = LQ_R_UP_DENSE_ABSORPTION + LQ_TABLE_TAUS * LQ_R_UP_TEXELS;
const int LQ_MULTIPLE_THIN_ABOVE = LQ_MULTIPLE_THIN_BELOW + LQ_TABLE_NODES * LQ_MULTIPLE_TEXELS;
const int LQ_MULTIPLE_DENSE_ABOVE = LQ_MULTIPLE_THIN_ABOVE + LQ_TABLE_NODES * LQ_MULTIPLE_TEXELS;
const int LQ_LOBE_ENERGY = LQ_MULTIPLE_DENSE_ABOVE + LQ_TABLE_NODES * LQ_MULTIPLE_TEXELS;
const int LQ_LOBE_ALPHA = LQ_LOBE_ENERGY + LQ_MIRROR_ALPHAS;
const int LQ_TABLE_TEXELS = LQ_LOBE_ALPHA + LQ_LOBE_VARIANCES;

#endif
