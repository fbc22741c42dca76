// The parser: a stack of token ranges whose next() executes directives and calls macros, and recursive
// descent over what comes out. Private to sdl/; each group of members has a file of its own.
#pragma once
#include <map>
#include <optional>
#include <set>

#include "function.hpp"
#include "parse.hpp"
#include "scope.hpp"

namespace nicol::sdl {

struct Token {
  Kind kind = Kind::end;
  std::uint32_t index = 0;  // symbol, mark, keyword or byte, as in Lexeme
  double number = 0;
  Location where;
  CellPtr cell;  // what the word means where it stands; null: undeclared
  TextPtr text;  // of a string, as written

  bool is(char mark) const { return is_mark(static_cast<unsigned char>(mark)); }
  bool is_mark(std::uint32_t mark) const { return kind == Kind::mark && index == mark; }
  bool is(Keyword keyword) const {
    return kind == Kind::word && index == static_cast<std::uint32_t>(keyword);
  }
  KeywordClass keyword_class() const {
    return kind == Kind::word ? class_of(index) : KeywordClass::none;
  }
  bool undeclared() const {
    const KeywordClass c = keyword_class();
    return kind == Kind::word && !cell && !is(Keyword::k_version) &&
           (c == KeywordClass::none || c == KeywordClass::directive);
  }
  template <typename T>
  const T* holds() const {
    return cell ? std::get_if<T>(&cell->value) : nullptr;
  }
};

// An error on its way to where the parse can go on; an empty message was reported already.
struct Failure {
  Location where;
  std::string message;
};

struct Halt {};  // reported; nothing sensible can follow

class Parser {
 public:
  Parser(const Options& options, Result& result);
  void run_file(const std::string& path);
  void run_text(const std::string& name, std::string text);

 private:
  // A #if, #switch, #while or #for that is open in a frame.
  struct Control {
    std::uint32_t opener, body;
    Keyword keyword;
    CellPtr counter;
    double stop = 0, step = 0;
  };
  // A range of lexemes being read: a file or a macro's body.
  struct Frame {
    TokenFilePtr tokens;
    std::uint32_t position, end, call;
    std::uint64_t serial;
    bool macro;
    std::vector<Control> controls;
  };
  // Where to come back to after a Failure.
  struct Mark {
    std::uint64_t serial;
    int grouping, nesting;
    bool expand_macros, holding;
  };
  struct Nest {
    explicit Nest(Parser& parser);
    ~Nest() { --parser_.nesting_; }
    Parser& parser_;
  };
  struct Group {  // inside ( ), < > or [ ]
    explicit Group(Parser& parser, bool in_braces = false)
        : nest(parser), parser_(parser), braces(in_braces) {
      ++parser_.grouping_;
    }
    ~Group();
    void close(char mark);  // reads the closing mark
    Nest nest;
    Parser& parser_;
    bool braces, open = true;
  };

  // parse.cpp: the whole
  void run(TokenFilePtr tokens);
  void predeclare();
  void statement();
  void add_statement(Item item);
  std::size_t most_weight() const { return options_.limits.items * 16; }

  // stream.cpp: tokens
  Token next();
  const Token& peek();
  const Token& peek_operator();  // what follows a complete operand: #declare and the like must wait
  void push_back(Token token) { pushed_.push_back(std::move(token)); }
  Token fetch();
  bool run_directive(const Token& token, std::uint32_t at);
  bool expand(Token& token);  // true: the token was a macro and is called now
  Token token_from(const Frame& frame, const Lexeme& lexeme) const;
  Token next_name();   // a word, not called if it is a macro
  Token next_held(bool expand);  // a directive that can wait stops it
  Token next_value();  // with the subscripts of an array read
  const Lexeme* peek_lexeme() const;
  void expect(char mark);
  bool accept(char mark);
  Frame& frame() { return frames_.back(); }
  void push_frame(TokenFilePtr tokens, std::uint32_t begin, std::uint32_t end, std::uint32_t call,
                  bool macro);
  void pop_frame();
  void take_step();

  // recover.cpp: errors
  void report(const Failure& failure);
  void warn(Location where, const std::string& message);
  bool is_reserved(const Token& token) const;
  std::string describe(const Token& token) const;
  std::string hint(const Token& token) const;
  [[noreturn]] void fail(const std::string& expected, const Token& found);
  [[noreturn]] void fail_in(const std::string& block, const Token& found);
  [[noreturn]] void fail_before(const Token& word, const Token& after);
  [[noreturn]] void fail_with(const Token& found, const std::string& message);
  Mark mark();
  void unwind(const Mark& mark);
  void trim_controls();
  enum class Skip : std::uint8_t { item, statement, directive };
  void recover(const Mark& mark, Skip skip);
  struct Skipping {
    Skip skip;
    int groups, braces, braces_lost;  // open brackets; braces that were open from the start
    bool moved;
  };
  bool stops(const Token& token, Skip skip, bool moved);
  bool ends(const Skipping& skipping, const Token& token);
  bool pass(Skipping& skipping, const Token& token) const;
  Token raw_token();

  // directives.cpp
  void directive(const Token& token, std::uint32_t at);
  void message_directive(Keyword keyword, const Token& token);
  void version_directive(const Token& token);
  void default_directive(const Token& token);
  // control.cpp
  void run_if(std::uint32_t at);
  bool condition(Keyword keyword);
  bool is_defined();
  void leave(std::uint64_t serial, std::uint32_t opener);
  void run_switch(std::uint32_t at);
  bool matches_case(Keyword keyword, double value);
  void run_while(std::uint32_t at);
  void run_for(std::uint32_t at);
  bool for_goes_on(const Control& control) const;
  void branch_reached(Keyword keyword, const Token& token);
  void end_reached(const Token& token, std::uint32_t at);
  void run_break(const Token& token);
  std::uint32_t end_of(const Frame& frame, std::uint32_t opener) const;
  bool linked(std::uint32_t at);
  // declare.cpp
  void declare_directive(bool local);
  void assign(const Token& name, bool local, bool element, CellPtr cell);
  void read_deprecation(const Token& name);
  void undef_directive();
  void semicolon(const Value& value);
  // macro.cpp
  void macro_directive(std::uint32_t at);
  void call_macro(const Token& name, MacroPtr macro);
  CellPtr argument();
  std::uint32_t call_index(const Token& name, const Macro& macro);
  // include.cpp
  void include_directive(const Token& token);
  std::string resolve(const std::string& name) const;
  TokenFilePtr load(const std::string& path, const std::string& shown, std::string& why);
  TokenFilePtr take_text(const std::string& shown, std::string text);
  // What an #include names: a text handed in, a file; null and why if there is none.
  TokenFilePtr handed_in(const std::string& name, std::string& why);
  TokenFilePtr file_of(const std::string& name, std::string& why);

  // block.cpp
  BlockPtr block(const Token& name);
  BlockPtr layers(const Token& name);
  bool another_layer();
  void items(Block& block, char closer);
  void item(Block& block);
  void word_item(Block& block, Token token);
  void value_item(Block& block, Token token);
  void list_item(Block& block, const Token& open);
  void add(Block& block, Item item);
  void finish(Block& block);
  // values.cpp
  Value rvalue(bool is_argument);
  Value array_value();
  void array_initialiser(Array& array, std::size_t dimension, std::size_t& at);
  CellPtr subscripted(const Token& name, ArrayPtr array);
  TextPtr string_value();
  TextPtr make_text(std::string text);
  bool starts_string(const Token& token) const;
  std::string raw_string();
  bool calls_spline(const Token& token);
  // strings.cpp
  std::string unescaped(const Token& literal) const;
  TextPtr string_call(const Token& name);
  std::string concat_call();
  std::string substr_call(Location where);
  std::string formatted(Location where, double value, double width, double precision);
  std::string vector_text(Location where);
  // expression.cpp
  Numbers choice();
  Numbers logic();
  Numbers relation();
  Numbers sum(std::optional<Numbers> first = {});
  Numbers product_of(std::optional<Numbers> first);
  Numbers factor();
  Numbers primary(Token token);
  Numbers postfix(Numbers value);
  Numbers member(const Numbers& value);
  Numbers constant(const Token& token);
  std::vector<double> components();
  double number();
  Numbers vector3();
  Numbers divided(const Numbers& a, const Numbers& b, Location where);
  bool compared(std::uint32_t mark, int order) const;
  bool starts_expression(const Token& token) const;
  Numbers call(const Token& name, const Value& value);
  // colour.cpp
  Numbers colour(Token token);
  bool colour_part(const Token& token, Numbers& c);
  // builtins.cpp
  Numbers float_call(const Token& name);
  Numbers other_call(const Token& name);
  Numbers array_call(const Token& name);
  Numbers vector_call(const Token& name);
  Numbers random_call(const Token& name);
  // compile.cpp
  FunctionPtr function_value();
  FunctionPtr block_function(const BlockPtr& body, Location where);
  FunctionPtr spline_function(const BlockPtr& block, Location where);
  BlockPtr function_text(const Token& name);
  void read_parameters(Function& f);
  void compile(Function& f, int level);
  void compile_unary(Function& f);
  void compile_operand(Function& f, const Token& token);
  void compile_call(Function& f, const Token& token, FunctionPtr callee);
  std::uint32_t compile_arguments(Function& f);
  void emit(Function& f, Step step);

  const Options& options_;
  Result& result_;
  Budget budget_;
  Symbols symbols_;
  Scope scope_;
  std::vector<Frame> frames_;
  std::vector<Token> pushed_;
  Token stop_;
  Location last_;
  bool expand_macros_ = true, holding_ = false;
  bool names_unknown_ = false;  // an include file was missing: undeclared names are no news
  int grouping_ = 0, nesting_ = 0;
  int groups_lost_ = 0, braces_lost_ = 0;  // what the failure on its way has left open
  std::size_t steps_left_, bytes_left_, document_weight_ = 0;
  std::uint64_t next_serial_ = 1, fetched_ = 0, recovered_at_ = 0;
  double version_ = 3.7;
  std::uint32_t defaults_ = 0;
  std::string scene_folder_;
  std::vector<std::uint32_t> seeds_;
  std::map<std::string, TokenFilePtr> files_;
  struct Deprecation {
    std::string message;
    bool once;
  };
  std::map<Symbol, Deprecation> deprecated_;
  std::map<std::pair<std::uint32_t, std::array<std::uint32_t, 4>>, std::uint32_t> call_indices_;
  std::map<BlockPtr, FunctionPtr> splines_;
  std::set<std::pair<std::string, std::array<std::uint32_t, 3>>> told_;
};

}  // namespace nicol::sdl
