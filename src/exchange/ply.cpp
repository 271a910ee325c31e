// SPDX-License-Identifier: Apache-2.0
// PLY: a header that describes records, then the records as text or binary of either byte order. Of them the elements
// "vertex" (x, y, z) and "face" (a list of indices) say something about shape; the others are passed over.
#include <bit>

#include "exchange/errors.h"
#include "exchange/formats.h"
#include "exchange/polygon_soup.h"
#include "exchange/text.h"

namespace aresta {

namespace {

enum class Kind { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
  std::string name;
  bool is_list = false;
  Kind count = Kind::u8, value = Kind::f32;
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

std::optional<Kind> kind_of(std::string_view word) {
  struct Name {
    const char* name;
    Kind kind;
  };
  static constexpr Name names[] = {
      {"char", Kind::i8},   {"int8", Kind::i8},     {"uchar", Kind::u8},   {"uint8", Kind::u8},
      {"short", Kind::i16}, {"int16", Kind::i16},   {"ushort", Kind::u16}, {"uint16", Kind::u16},
      {"int", Kind::i32},   {"int32", Kind::i32},   {"uint", Kind::u32},   {"uint32", Kind::u32},
      {"float", Kind::f32}, {"float32", Kind::f32}, {"double", Kind::f64}, {"float64", Kind::f64}};
  for (const Name& n : names) {
    if (word == n.name) return n.kind;
  }
  return {};
}

class PlyReader {
 public:
  explicit PlyReader(const std::string& data) : data_(data), text_(data) {}

  Result<PolygonSoup> run() {
    ARESTA_CHECK(read_header());
    PolygonSoup soup;
    for (const Element& element : elements_) {
      for (std::uint64_t i = 0; i < element.count; ++i) ARESTA_CHECK(read_record(element, soup));
    }
    return soup;
  }

 private:
  Error bad(const std::string& what) const { return Error{errors::bad_content, "the PLY file: " + what}; }

  Status read_header() {
    std::string_view line;
    if (!text_.next_line(line) || line != "ply") return bad("it does not begin with ply");
    bool has_format = false;
    while (text_.next_line(line)) {
      std::string_view rest = line;
      const std::string_view key = take_word(rest);
      if (key == "format") {
        const std::string_view format = take_word(rest);
        binary_ = format != "ascii";
        big_ = format == "binary_big_endian";
        if (binary_ && !big_ && format != "binary_little_endian") return bad("its format is unknown");
        has_format = true;
      } else if (key == "element") {
        Element element;
        element.name = take_word(rest);
        std::int64_t count = 0;
        if (!to_number(take_word(rest), count) || count < 0) return bad("an element has no count");
        element.count = static_cast<std::uint64_t>(count);
        elements_.push_back(std::move(element));
      } else if (key == "property") {
        if (elements_.empty()) return bad("a property stands before any element");
        Property property;
        std::string_view word = take_word(rest);
        property.is_list = word == "list";
        if (property.is_list) {
          const auto count = kind_of(take_word(rest));
          if (!count) return bad("a property has an unknown type");
          property.count = *count;
          word = take_word(rest);
        }
        const auto value = kind_of(word);
        if (!value) return bad("a property has an unknown type");
        property.value = *value;
        property.name = take_word(rest);
        elements_.back().properties.push_back(std::move(property));
      } else if (key == "end_header") {
        at_ = text_.position();
        return has_format ? Status() : bad("its format is not given");
      }
    }
    return bad("its header has no end");
  }

  static std::size_t size_of(Kind kind) {
    switch (kind) {
      case Kind::i8:
      case Kind::u8:
        return 1;
      case Kind::i16:
      case Kind::u16:
        return 2;
      case Kind::f64:
        return 8;
      default:
        return 4;
    }
  }

  bool read_value(Kind kind, double& value) {
    if (!binary_) {
      const std::string_view word = text_.word();
      return to_number(word, value);
    }
    const std::size_t size = size_of(kind);
    if (at_ + size > data_.size()) return false;
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i) {
      const std::size_t byte = big_ ? size - 1 - i : i;
      bits |= std::uint64_t{static_cast<unsigned char>(data_[at_ + byte])} << (8 * i);
    }
    at_ += size;
    switch (kind) {
      case Kind::i8:
        value = static_cast<std::int8_t>(bits);
        break;
      case Kind::i16:
        value = static_cast<std::int16_t>(bits);
        break;
      case Kind::i32:
        value = static_cast<std::int32_t>(bits);
        break;
      case Kind::f32:
        value = std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        break;
      case Kind::f64:
        value = std::bit_cast<double>(bits);
        break;
      default:
        value = static_cast<double>(bits);
    }
    return true;
  }

  Status read_record(const Element& element, PolygonSoup& soup) {
    const bool is_vertex = element.name == "vertex", is_face = element.name == "face";
    Vec3 p;
    for (const Property& property : element.properties) {
      double count = 1;
      if (property.is_list && !read_value(property.count, count))
        return bad("it is cut off or holds a word that is no number");
      if (!(count >= 0 && count < 1e9)) return bad("a list has an impossible length");
      const bool indices =
          is_face && property.is_list && (property.name == "vertex_indices" || property.name == "vertex_index");
      for (double i = 0; i < count; ++i) {
        double value = 0;
        if (!read_value(property.value, value)) return bad("it is cut off or holds a word that is no number");
        if (is_vertex && property.name.size() == 1 && property.name[0] >= 'x' && property.name[0] <= 'z')
          p[property.name[0] - 'x'] = value;
        if (!indices) continue;
        if (!(value >= 0 && value < static_cast<double>(soup.points.size())))
          return bad("a face names a point that does not exist");
        soup.corners.push_back(static_cast<std::uint32_t>(value));
      }
      if (indices) soup.close_polygon();
    }
    if (!is_vertex) return {};
    if (!is_finite(p)) return bad("a coordinate is not a finite number");
    soup.points.push_back(p);
    return {};
  }

  const std::string& data_;
  TextReader text_;
  std::vector<Element> elements_;
  bool binary_ = false, big_ = false;
  std::size_t at_ = 0;
};

}  // namespace

Result<Model> read_ply(const ReadArguments& in) {
  ARESTA_TRY(const PolygonSoup soup, PlyReader(in.data).run());
  return import_soup(soup, in.options, in.report, in.context);
}

}  // namespace aresta
