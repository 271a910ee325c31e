// SPDX-License-Identifier: Apache-2.0
#include "operator_cases.h"

#include <string_view>

namespace aresta {

namespace {

// Changes are of vertices, edges, faces, loops, shells, regions.
constexpr OperatorCase cases[] = {
    {"M_MR", "mmr", {0, 0, 0, 0, 0, 1}, "K_M kmr", "nothing"},
    {"M_SV", "msv", {1, 0, 0, 0, 1, 0}, "K_V kvs", "nothing but infinite space"},
    {"M_RSFL", "mrsfl", {0, 0, 1, 1, 1, 1}, "K_F kflrs", "a point"},
    {"M_EV", "mev", {1, 1, 0, 0, 0, 0}, "K_V kve", "a point"},
    {"M_E", "me", {0, 1, 0, 0, 0, 0}, "K_E ke", "both ends of a path of two wires"},
    {"M_E", "meks", {0, 1, 0, 0, -1, 0}, "K_E kems", "two points"},
    {"M_F", "mfl", {0, 0, 1, 1, 0, 0}, "K_F kfl", "a triangle of wires"},
    {"M_F", "mflrs", {0, 0, 1, 1, 1, 1}, "K_F kflrs", "a disc, closed by a second one"},
    {"M_F", "mflks", {0, 0, 1, 2, -1, 0}, "K_F kflms", "two closed wires, between which a ring comes"},
    {"MM_VL", "mvl", {1, 0, 0, 1, 0, 0}, "K_V kvl", "a disc"},
    {"MM_EV", "mev", {1, 1, 0, 0, 0, 0}, "K_V kve", "a disc"},
    {"MM_E", "mefl", {0, 1, 1, 1, 0, 0}, "K_E kefl", "a face with two corners"},
    {"MM_E", "mekl", {0, 1, 0, -1, 0, 0}, "K_E keml", "a disc with a point inside"},
    {"K_V", "kvs", {-1, 0, 0, 0, -1, 0}, "M_SV msv", "a point"},
    {"K_V", "kve", {-1, -1, 0, 0, 0, 0}, "M_EV mev", "a wire"},
    {"K_V", "kvl", {-1, 0, 0, -1, 0, 0}, "MM_VL mvl", "a disc with a point inside"},
    {"K_V", "kvlms", {-1, 0, 0, -2, 1, 0}, "take_back", "two discs that touch in a point inside both"},
    {"K_V", "kvfle", {-1, -2, -1, -1, 0, 0}, "take_back", "a face with two corners"},
    {"K_V", "kvsfle", {-1, -1, -1, -1, -1, 0}, "take_back", "a disc"},
    {"K_V", "kvrsfl", {-1, 0, -1, -1, -2, -1}, "take_back", "a sphere on a point"},
    {"K_V", "kvrsfle", {-1, -1, -2, -2, -2, -1}, "take_back", "a sphere of two discs"},
    {"K_E", "ke", {0, -1, 0, 0, 0, 0}, "M_E me", "a triangle of wires"},
    {"K_E", "kems", {0, -1, 0, 0, 1, 0}, "M_E meks", "a wire"},
    {"K_E", "keml", {0, -1, 0, 1, 0, 0}, "MM_E mekl", "an edge that ends inside a disc"},
    {"K_E", "kefl", {0, -1, -1, -1, 0, 0}, "MM_E mefl", "two faces with two corners and a common edge"},
    {"K_E", "keflms", {0, -1, -1, -2, 1, 0}, "take_back", "a ring"},
    {"K_F", "kfl", {0, 0, -1, -1, 0, 0}, "M_F mfl", "a disc"},
    {"K_F", "kflms", {0, 0, -1, -2, 1, 0}, "M_F mflks", "a ring"},
    {"K_F", "kflrs", {0, 0, -1, -1, -1, -1}, "M_F mflrs", "a sphere of two discs"},
    {"K_M", "kmr", {0, 0, 0, 0, 0, -1}, "M_MR mmr", "nothing but infinite space"},
    {"G_V", "gvksv", {-1, 0, 0, 0, -1, 0}, "take_back", "two points"},
    {"G_V", "gvkv", {-1, 0, 0, 0, 0, 0}, "take_back", "both ends of a path of two wires"},
    {"G_E", "geke", {0, -1, 0, 0, 0, 0}, "take_back", "two wires between the same vertices"},
    {"G_E", "gekfle", {0, -1, -1, -1, 0, 0}, "take_back", "both edges of a face with two corners"},
    {"G_E", "gekev", {-1, -1, 0, 0, 0, 0}, "take_back", "two wires from one vertex"},
    {"G_E", "geksev", {-2, -1, 0, 0, -1, 0}, "take_back", "two separate wires"},
    {"G_F", "gfksflev", {-1, -1, -1, -1, -1, 0}, "take_back", "two separate discs"},
    {"G_F", "gfkflev", {-1, -2, -1, -1, 0, 0}, "take_back", "two faces with two corners, one of them common"},
    {"ESPLIT", "mev", {1, 1, 0, 0, 0, 0}, "ESQUEEZE kev", "a wire"},
    {"ESQUEEZE", "kev", {-1, -1, 0, 0, 0, 0}, "ESPLIT mev", "the second wire of two"},
    {"ESQUEEZE", "ke", {0, -1, 0, 0, 0, 0}, "M_E me", "a closed wire"},
};

constexpr OperatorText texts[] = {
    {"M_MR", "m_mr()", "A complex with nothing but infinite space.", "(nothing)  ->  [ r0 ]", "none",
     "nothing was there"},
    {"M_SV", "m_sv(k, region, wanted)", "A vertex alone in a region.", "[   ]  ->  [ . ]",
     "the region is live; an id that is wanted for the vertex is free (`in_use`)", "nothing that was there changes"},
    {"M_RSFL", "m_rsfl(k, at, region, filled)", "A closed face, a sphere, at one vertex; its inside is a new region.",
     ".  ->  (.)",
     "the vertex touches the region (`not_in_region`); where it touches several, one is named (`ambiguous_place`)",
     "the region stays as the outside of the sphere; the new region is new"},
    {"M_EV", "m_ev(k, at, region)", "A wire from a vertex to a new one.", ".  ->  .--.",
     "the vertex touches the region (`not_in_region`); where it touches several, one is named (`ambiguous_place`)",
     "nothing that was there changes"},
    {"M_E", "m_e(k, start, end, region)",
     "A wire between two vertices, which may be one and the same; it joins their shells.", ".  .  ->  .--.",
     "both vertices touch the region (`not_in_region`); where there are several such, one is named (`ambiguous_place`)",
     "nothing that was there changes"},
    {"M_F", "m_f(k, spec)",
     "A face into circuits of edges. When its sides are not connected it divides its region; it joins the shells of "
     "its "
     "circuits.",
     ".--.      .--.\n|  |  ->  |##|\n.--.      .--.",
     "circuits are closed (`open_circuit`) and touch one region (`not_in_region`); sectors and the region are named "
     "where "
     "there is a choice (`ambiguous_place`); the face passes through no other one about a vertex (`no_space`); what is "
     "said to go into the new region can go there (`wrong_place`, `cuts_wire`)",
     "edges and vertices stay; the divided region stays on the side that the new one does not get"},
    {"MM_VL", "mm_vl(k, face)", "A vertex inside a face, as a loop of it.", "|     |  ->  |  .  |", "the face is live",
     "the face stays"},
    {"MM_EV", "mm_ev(k, at)", "An edge from a corner of a face into the face, to a new vertex.", "|     |  ->  |--.  |",
     "the corner is one (`wrong_place`)", "the face and its loop stay"},
    {"MM_E", "mm_e(k, from, to, moved)",
     "An edge across a face between two corners: of one loop, and the face is divided, or of two, which become one.",
     "|   |  ->  |---|", "both corners are of one face; `moved` names other loops of it, each once (`wrong_place`)",
     "the face and the loop of the first corner stay; the new face lies to the right of the edge and takes the moved "
     "loops"},
    {"K_V", "k_v(k, v)",
     "A vertex and what needs it: a strut with its edge, a loop with its vertex, else every face and edge there.",
     ".--.  ->  .", "the vertex is live",
     "what is not at the vertex stays; regions that become one are kept as by K_F"},
    {"K_E", "k_e(k, e, kept)",
     "An edge. A wire goes alone, an edge twice in one loop leaves two loops, an edge between two faces of agreeing "
     "orientation leaves one face; else its faces go too.",
     "|---|  ->  |   |", "the face that is kept is at the edge (`wrong_place`)",
     "of two faces the one named stays, else the one with the smaller id; it takes the loops of the other. When the "
     "edge is all of a loop of one face, the other face stays"},
    {"K_F", "k_f(k, f, kept)",
     "A face. Its edges stay, those of no other face as wires; two regions at its sides become one.",
     ".--.      .--.\n|##|  ->  |  |\n.--.      .--.",
     "the region that is kept touches the face (`not_in_region`), and the infinite one is never killed (`in_use`)",
     "of two regions the one named stays, else the infinite one, else the one in front"},
    {"K_M", "k_m(k)", "The whole complex.", "[ r0 ]  ->  (nothing)",
     "nothing is left but infinite space (`in_use`, naming what is left)", "nothing is left"},
    {"G_V", "g_v(k, kept, gone)", "Two vertices become one.", ".  .  ->  .",
     "they differ (`wrong_place`) and touch a common region (`not_in_region`); no face would have the vertex as a loop "
     "and in another loop (`wrong_place`)",
     "`kept` stays"},
    {"G_E", "g_e(k, kept, gone, gluing)",
     "Two edges become one, and their ends; a face with just these two edges goes; what is enclosed is a new region.",
     ".--.\n.--.  ->  .--.",
     "they differ, and both are closed or none (`wrong_place`); they have sectors in one region (`not_in_region`), "
     "which "
     "are named where there is a choice (`ambiguous_place`); faces do not pass through each other (`no_space`); "
     "what is said to go into a new region can go there (`wrong_place`, `cuts_wire`)",
     "`kept` and its ends stay; the divided region stays on the side that the new one does not get"},
    {"G_F", "g_f(k, kept, gone, pairs)",
     "Two faces become one, laid on each other with sides that look at each other; edges and vertices are glued pair "
     "by "
     "pair.",
     "|#|\n|#|  ->  |#|",
     "the sides look into one region (`not_in_region`); all loops are paired, with equal numbers of edges "
     "(`wrong_place`); orientations fit (`senses_disagree`); nothing but the space between them is enclosed "
     "(`would_pinch`), and nothing that is outside of it is cut off (`cuts_wire`); faces do not pass through each "
     "other "
     "(`no_space`)",
     "the kept face with its loops, edges and vertices stays"},
    {"ESPLIT", "esplit(k, e)", "A vertex in the middle of an edge.", ".-----.  ->  .--.--.", "the edge is live",
     "the old edge stays with its start; the new edge runs on in the same direction"},
    {"ESQUEEZE", "esqueeze(k, e, kept)", "An edge shrinks to a vertex.", ".--.--.  ->  .-----.",
     "the vertex that is kept is an end of the edge; no face would have it as a loop and in another loop "
     "(`wrong_place`); "
     "faces enclose afterwards what they did, and a closed edge is a wire (`would_pinch`)",
     "the vertex named stays, else the start of the edge"},
};

std::string signed_number(int n) {
  return n == 0 ? "" : n > 0 ? "+" + std::to_string(n) : std::to_string(n);
}

}  // namespace

std::span<const OperatorText> operator_texts() {
  return texts;
}

std::span<const OperatorCase> operator_cases() {
  return cases;
}

std::string operators_page() {
  std::string page =
      "# Operators\n\n"
      "The non-manifold operators of `src/topology/operators.h`, the only way to change a complex step by step. Each "
      "checks its\narguments first and leaves the complex as it was when it fails, says which of its sub-cases "
      "happened, and is taken back\nexactly, ids included, by `take_back`. Sub-cases are named by what is made (m) and "
      "killed (k): v vertex, e edge, f face,\nl loop, s shell, r region; `g` is for gluing. What happens beyond the "
      "names below is added in the same letters.\n\n"
      "Every operator refuses ids that name nothing (`unknown_part`). The numbers are the changes of vertices, edges, "
      "faces,\nloops, shells and regions on the model named in the row; the test `Operators.NAME_SUBCASE` of "
      "`tests/topology` makes\neach of these changes. The inverse leads back to the same dump, byte for byte.\n\n"
      "This page is made from `tests/topology/operator_cases.cpp`; where it differs, the test "
      "`OperatorsPage.IsUpToDate` "
      "leaves a new one\nin the build folder.\n";
  for (const OperatorText& text : texts) {
    page += "\n## ";
    page += text.name;
    page += "\n\n`" + std::string(text.call) + "`. " + text.purpose + "\n\n```\n" + text.sketch + "\n```\n\n";
    page += "| sub-case | V | E | F | L | S | R | on | inverse |\n|---|---|---|---|---|---|---|---|---|\n";
    for (const OperatorCase& row : cases) {
      if (std::string_view(row.name) != text.name) continue;
      page += "| " + std::string(row.sub_case) + " |";
      const CountChange& d = row.change;
      for (const int n : {d.vertices, d.edges, d.faces, d.loops, d.shells, d.regions}) {
        page += " " + signed_number(n) + (n == 0 ? "|" : " |");
      }
      page += " " + std::string(row.model) + " | " + row.inverse + " |\n";
    }
    page += "\nPreconditions: " + std::string(text.preconditions) + ".\n\nAttributes: " + text.attributes + ".\n";
  }
  return page;
}

}  // namespace aresta
