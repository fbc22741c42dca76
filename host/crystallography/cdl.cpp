// A reader of one line: see cdl.hpp.
#include "host/crystallography/cdl.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>

namespace nicol::crystallography {

namespace {

struct NamedForm {
  const char* name;
  bool hexagonal, tetragonal, cubic;  // the systems that have it
  Miller face;
};
const NamedForm named_forms[] = {{"octahedron", false, false, true, {1, 1, 1}},
                                 {"cube", false, false, true, {1, 0, 0}},
                                 {"dodecahedron", false, false, true, {1, 1, 0}},
                                 {"trapezohedron", false, false, true, {2, 1, 1}},
                                 {"trisoctahedron", false, false, true, {2, 2, 1}},
                                 {"tetrahexahedron", false, false, true, {2, 1, 0}},
                                 {"hexoctahedron", false, false, true, {3, 2, 1}},
                                 {"prism", true, true, false, {1, 0, 0}},
                                 {"prism_1", true, true, false, {1, 0, 0}},
                                 {"prism_2", true, true, false, {1, 1, 0}},
                                 {"basal", true, true, false, {0, 0, 1}},
                                 {"pinacoid", true, true, false, {0, 0, 1}},
                                 {"rhombohedron", true, false, false, {1, 0, 1}},
                                 {"rhombohedron_r", true, false, false, {1, 0, 1}},
                                 {"rhombohedron_z", true, false, false, {0, 1, 1}},
                                 {"pyramid", true, true, false, {1, 0, 1}},
                                 {"dipyramid", true, true, false, {1, 0, 1}},
                                 {"bipyramid", false, true, false, {1, 1, 1}},
                                 {"scalenohedron", true, false, false, {2, 1, 1}}};

bool is_hexagonal(System system) {
  return system == System::trigonal || system == System::hexagonal;
}

const NamedForm* find_form(const std::string& name, System system) {
  for (const NamedForm& row : named_forms) {
    const bool has = is_hexagonal(system)            ? row.hexagonal
                     : system == System::tetragonal ? row.tetragonal
                     : system == System::cubic      ? row.cubic
                                                    : false;
    if (has && name == row.name) return &row;
  }
  return nullptr;
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Cdl read() {
    Cdl cdl;
    read_system(cdl);
    expect(':');
    do {
      read_form(cdl);
    } while (accept('+'));
    while (accept('|')) read_modification(cdl);
    if (at_ == text_.size()) return cdl;
    const char c = text_[at_];
    if (c == '~' || c == '>') fail(at_, "aggregates and overgrowths of CDL 2 are not read");
    if (c == '[') fail(at_, "features of CDL 2 are not read");
    fail(at_, std::string("unexpected '") + c + "'");
  }

 private:
  [[noreturn]] static void fail(std::size_t at, std::string message) {
    throw CdlError{at, std::move(message)};
  }

  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }

  bool accept(char c) {
    skip_blanks();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    skip_blanks();
    return true;
  }

  void expect(char c) {
    if (!accept(c)) fail(at_, std::string("expected '") + c + "'");
  }

  std::string word() {
    skip_blanks();
    const std::size_t from = at_;
    while (at_ < text_.size() &&
           (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
      ++at_;
    return std::string(text_.substr(from, at_ - from));
  }

  double number() {
    skip_blanks();
    const std::size_t from = at_;
    while (at_ < text_.size() && (std::isdigit(static_cast<unsigned char>(text_[at_])) ||
                                  text_[at_] == '.' || text_[at_] == '-'))
      ++at_;
    const std::string digits(text_.substr(from, at_ - from));
    char* end = nullptr;
    const double value = std::strtod(digits.c_str(), &end);
    if (digits.empty() || *end) fail(from, "expected a number");
    return value;
  }

  std::string until(char closing) {
    const std::size_t from = at_, to = text_.find(closing, at_);
    if (to == std::string_view::npos) fail(at_, std::string("expected '") + closing + "'");
    at_ = to + 1;
    return std::string(text_.substr(from, to - from));
  }

  void read_system(Cdl& cdl) {
    skip_blanks();
    const std::size_t from = at_;
    const std::string name_read = word();
    const auto system = find_system(name_read);
    if (!system)
      fail(from, name_read == "amorphous" ? "an amorphous body has no faces"
                                          : "unknown crystal system '" + name_read + "'");
    cdl.system = *system;
    cdl.point_group = holohedry(*system);
    const std::size_t bracket = at_;
    if (!accept('[')) return;
    cdl.point_group = until(']');
    const auto group = find_point_group(cdl.point_group);
    if (!group) fail(bracket + 1, "unknown point group '" + cdl.point_group + "'");
    if (group->system != cdl.system)
      fail(bracket + 1, "point group '" + cdl.point_group + "' is " + name(group->system) +
                            ", not " + name(cdl.system));
  }

  void read_form(Cdl& cdl) {
    skip_blanks();
    std::size_t from = at_;
    CdlForm form;
    if (accept('{')) {
      form.face = indices_until('}', from + 1, cdl.system);
    } else {
      std::string name_read = word();
      if (!find_form(name_read, cdl.system) && accept(':')) {  // a label
        skip_blanks();
        from = at_;
        if (accept('{')) {
          form.face = indices_until('}', from + 1, cdl.system);
          name_read.clear();
        } else {
          name_read = word();
        }
      }
      if (!name_read.empty() || form.face == Miller{}) form.face = named(name_read, from, cdl);
    }
    if (accept('@')) {
      const std::size_t at_distance = at_;
      form.distance = number();
      if (!(form.distance > 0)) fail(at_distance, "a distance from the centre is positive");
    }
    cdl.forms.push_back(form);
  }

  Miller named(const std::string& name_read, std::size_t from, const Cdl& cdl) {
    if (from < text_.size() && text_[from] == '(') fail(from, "groups of CDL 2 are not read");
    if (name_read.empty()) fail(from, "expected a form, as {10-11} or a name");
    if (const NamedForm* row = find_form(name_read, cdl.system)) return row->face;
    fail(from, "no form '" + name_read + "' in the " + name(cdl.system) + " system");
  }

  Miller indices_until(char closing, std::size_t from, System system) {
    const auto indices = parse_indices(until(closing));
    if (!indices) fail(from, "expected indices, as 10-11 or 1 0 -1 1");
    std::string why;
    const auto face = face_of_indices(*indices, why);
    if (!face) fail(from, why);
    if (indices->size() == 4 && !is_hexagonal(system))
      fail(from, "four indices belong to hexagonal axes");
    return *face;
  }

  void read_modification(Cdl& cdl) {
    skip_blanks();
    const std::size_t from = at_;
    const std::string name_read = word();
    if (name_read == "twin") return read_twin(cdl);
    if (name_read == "phenomenon") fail(from, "phenomena of CDL 2 are not read");
    fail(from, "'" + name_read + "' is not read: only 'twin(...)' follows '|'" +
                   (name_read == "elongate" || name_read == "taper" || name_read == "flatten"
                        ? "; the angles between faces of a crystal are fixed, distances are not"
                        : ""));
  }

  void read_twin(Cdl& cdl) {
    expect('(');
    const std::size_t from = at_;
    if (accept('[')) {
      cdl.twin = custom_twin(from);
    } else {
      std::string law = word();
      if (law == "spinel_law") law = "spinel";
      const auto& laws = twin_laws();
      const auto row = std::find_if(laws.begin(), laws.end(),
                                    [&](const NamedTwinLaw& l) { return law == l.name; });
      if (row == laws.end()) fail(from, "unknown twin law '" + law + "'");
      cdl.twin = row->law;
    }
    expect(')');
  }

  // [u,v,w], angle[, contact|penetration]
  TwinLaw custom_twin(std::size_t from) {
    const auto indices = parse_indices(until(']') + ",");
    std::string why = "expected [u, v, w]";
    const auto axis = indices && indices->size() == 3 ? face_of_indices(*indices, why)
                                                      : std::nullopt;
    if (!axis) fail(from + 1, why);
    TwinLaw law{TwinLaw::Operation::rotation_about_edge, *axis, 180, std::nullopt, false};
    if (accept(',')) law.angle_deg = number();
    if (accept(',')) {
      const std::size_t at_kind = at_;
      const std::string kind = word();
      if (kind != "contact" && kind != "penetration")
        fail(at_kind, "expected 'contact' or 'penetration'");
      law.penetration = kind == "penetration";
    }
    return law;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::variant<Cdl, CdlError> parse_cdl(std::string_view text) {
  try {
    return Reader(text).read();
  } catch (const CdlError& error) {
    return error;
  }
}

}  // namespace nicol::crystallography
