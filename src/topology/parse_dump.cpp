// SPDX-License-Identifier: Apache-2.0
#include "topology/parse_dump.h"

#include <string>
#include <tuple>

#include "topology/dump.h"
#include "topology/lexer.h"
#include "topology/records.h"

namespace aresta {

namespace {

// Ids are shorter than this, so that twice an id still is a row (records.h refuses most of them anyway).
constexpr std::uint32_t largest_id = (1u << 30) - 1;

class Reader : WordReader {
 public:
  explicit Reader(std::string_view text) : WordReader(text, errors::bad_dump) {}

  Result<ComplexRecords> run() {
    read_head();
    while (accept("region")) read_region();
    while (accept("face")) read_face();
    while (accept("edge")) read_edge();
    while (accept("vertex")) read_vertex();
    if (!lexer_.word().text.empty()) fail("'region', 'face', 'edge' or 'vertex' (in this order)");
    if (error_) return *std::move(error_);
    return std::move(records_);
  }

 private:
  void end_line() {
    if (!accept("\n")) fail("the end of the line");
  }
  std::uint32_t line() const { return lexer_.word().line; }

  static std::string_view without_sign(std::string_view text) {
    return text.empty() || (text[0] != '+' && text[0] != '-') ? text : text.substr(1);
  }
  bool at_id(char letter) const {
    const std::string_view text = lexer_.word().text;
    std::uint32_t id;
    return !failed() && !text.empty() && text[0] == letter && read_number(text.substr(1), largest_id, &id);
  }
  bool at_signed_id(char letter) const {
    const std::string_view text = without_sign(lexer_.word().text);
    std::uint32_t id;
    return !failed() && text.size() < lexer_.word().text.size() && !text.empty() && text[0] == letter &&
           read_number(text.substr(1), largest_id, &id);
  }
  template <class IdType>
  IdType id(char letter, std::string_view wanted) {
    if (!at_id(letter)) {
      fail(wanted);
      return {};
    }
    std::uint32_t number = 0;
    read_number(lexer_.take().text.substr(1), largest_id, &number);
    return IdType(number);
  }
  /// The id behind a sign, which is true for "-".
  template <class IdType>
  std::pair<IdType, bool> signed_id(char letter, std::string_view wanted) {
    if (!at_signed_id(letter)) {
      fail(wanted);
      return {};
    }
    std::uint32_t number = 0;
    const std::string_view text = lexer_.take().text;
    read_number(text.substr(2), largest_id, &number);
    return {IdType(number), text[0] == '-'};
  }
  VertexId vertex() { return id<VertexId>('v', "a vertex, as in v5,"); }
  EdgeId edge() { return id<EdgeId>('e', "an edge, as in e7,"); }
  CoedgeId coedge() { return id<CoedgeId>('c', "a coedge, as in c40,"); }
  LoopId loop() { return id<LoopId>('l', "a loop, as in l3,"); }
  FaceId face() { return id<FaceId>('f', "a face, as in f12,"); }
  RegionId region() { return id<RegionId>('r', "a region, as in r0,"); }

  void read_head() {
    expect("aresta");
    expect("complex");
    if (!failed() && !is("1")) {
      error_ = Error{errors::dump_version, not_as_expected("version 1", lexer_.word())};
    }
    accept("1");
    end_line();
  }

  void read_region() {
    ComplexRecords::Region record;
    record.line = line();
    record.id = region();
    expect(":");
    if (accept("filled")) {
      record.filled = true;
    } else if (!accept("empty") && !accept("infinite")) {
      fail("'infinite', 'filled' or 'empty'");
    }
    end_line();
    records_.regions.push_back(record);
    while (is("shell")) read_shell(record.id);
  }

  void read_shell(RegionId r) {
    const auto index = static_cast<std::uint32_t>(records_.shells.size());
    records_.shells.push_back({r, line()});
    expect("shell");
    do {
      Item item;
      if (at_signed_id('f')) {
        const auto [f, is_back] = signed_id<FaceId>('f', "");
        item = FaceUse(f, is_back ? 1 : 0);
      } else if (at_id('e')) {
        item = edge();
      } else if (at_id('v')) {
        item = vertex();
      } else {
        fail("a side, a wire or a point, as in +f12, -f12, e7, v5,");
      }
      records_.items.push_back({item, index});
    } while (!failed() && !is("\n"));
    end_line();
  }

  void read_face() {
    ComplexRecords::Face record;
    record.line = line();
    record.id = face();
    expect(":");
    expect("front");
    region();
    expect(",");
    expect("back");
    region();
    end_line();
    records_.faces.push_back(record);
    do {
      read_loop(static_cast<std::uint32_t>(records_.faces.size() - 1));
    } while (is("loop"));
  }

  void read_loop(std::uint32_t face_index) {
    ComplexRecords::Loop record;
    record.face = face_index;
    expect("loop");
    record.line = line();
    record.id = loop();
    if (accept(":")) {
      record.vertex = vertex();
      end_line();
      records_.loops.push_back(record);
      return;
    }
    end_line();
    records_.loops.push_back(record);
    do {
      read_coedge(static_cast<std::uint32_t>(records_.loops.size() - 1));
    } while (is("coedge"));
  }

  void read_coedge(std::uint32_t loop_index) {
    ComplexRecords::Coedge record;
    record.loop = loop_index;
    expect("coedge");
    record.line = line();
    record.id = coedge();
    expect(":");
    std::tie(record.edge, record.reversed) = signed_id<EdgeId>('e', "an edge with its sense, as in +e7 or -e7,");
    expect(",");
    vertex();
    expect("to");
    vertex();
    expect(",");
    expect("radial");
    coedge();
    end_line();
    records_.coedges.push_back(record);
  }

  void read_edge() {
    ComplexRecords::Edge record;
    record.line = line();
    record.id = edge();
    expect(":");
    record.start = vertex();
    expect("to");
    record.end = vertex();
    expect(",");
    records_.edges.push_back(record);
    if (accept("wire")) {
      expect("in");
      region();
    } else if (accept("radial")) {
      do {
        records_.uses.push_back({coedge(), static_cast<std::uint32_t>(records_.edges.size() - 1)});
      } while (!failed() && !is("\n"));
    } else {
      fail("'radial' or 'wire'");
    }
    end_line();
  }

  void read_vertex() {
    records_.vertices.push_back({VertexId(), line()});
    records_.vertices.back().id = vertex();
    expect(":");
    if (accept("in")) {
      region();
    } else {
      while (at_signed_id('e')) lexer_.take();
      while (at_id('l')) lexer_.take();
      if (!is("\n")) fail("an edge with its sense, a loop or 'in' with a region");
    }
    end_line();
  }

  ComplexRecords records_;
};

/// What is said twice in a dump, and its order, is right when the dump of the result has the same words.
Status compare(std::string_view text, const Complex& k) {
  const std::string canonical = dump(k);
  Lexer found(text), wanted(canonical);
  while (found.word().text == wanted.word().text) {
    if (found.word().text.empty()) return {};
    found.take();
    wanted.take();
  }
  Error error{errors::dump_differs, not_as_expected(shown(wanted.word()), found.word())};
  error.hint = "a dump names everything in one order, by ids, and in agreement with itself";
  return error;
}

}  // namespace

Result<Complex> parse_dump(std::string_view text) {
  ARESTA_TRY(const ComplexRecords records, Reader(text).run());
  ARESTA_TRY(Complex k, rebuild(records));
  ARESTA_CHECK(compare(text, k));
  return k;
}

}  // namespace aresta
