package dev.eventchain.constraints.editing;

import dev.eventchain.constraints.document.ClauseStarts;
import dev.eventchain.ocl.text.Keywords;
import dev.eventchain.ocl.text.Tokens;
import java.util.ArrayList;
import java.util.List;

/**
 * A clause of a document as far as its first words tell, whatever is wrong in it.
 *
 * @param keyword such as {@code context} or {@code inv}
 * @param start the offset of its first word
 * @param end the offset after its last token
 * @param name its name; empty if it has none
 * @param nameStart the offset of the name; that of the keyword without one
 */
record Section(String keyword, int start, int end, String name, int nameStart) {

  /** Returns the clauses of a text, in its order. */
  static List<Section> in(Tokens tokens) {
    List<Section> sections = new ArrayList<>();
    int first = next(tokens, 0);
    while (first < tokens.size()) {
      int next = next(tokens, first + 1);
      sections.add(of(tokens, first, next));
      first = next;
    }
    return sections;
  }

  private static int next(Tokens tokens, int from) {
    int at = from;
    while (at < tokens.size() && !ClauseStarts.at(tokens, at)) {
      at++;
    }
    // The keyword after 'static' belongs to the same clause.
    return at > 0 && from == at && tokens.is(at - 1, "static") ? next(tokens, at + 1) : at;
  }

  private static Section of(Tokens tokens, int first, int next) {
    String keyword = tokens.text(first).equals("static") ? "def" : tokens.text(first);
    int name =
        switch (keyword) {
          case "def" -> colon(tokens, first, next) + 1;
          case "endpackage", "import", "include", "library" -> next;
          default -> first + 1;
        };
    boolean named = name < next && tokens.isName(name) && !Keywords.ALL.contains(tokens.text(name));
    int last = named ? name + 1 : name;
    while (named && tokens.is(last, "::") && last + 1 < next && tokens.isName(last + 1)) {
      last += 2;
    }
    boolean aliased = named && keyword.equals("context") && tokens.is(last, ":");
    if (aliased && last + 1 < next && tokens.isName(last + 1)) {
      name = last + 1;
      last = name + 1;
    }
    String text = named ? tokens.words(name, last).replace(" ", "") : "";
    int nameStart = named ? tokens.start(name) : tokens.start(first);
    return new Section(keyword, tokens.start(first), tokens.end(next - 1), text, nameStart);
  }

  private static int colon(Tokens tokens, int first, int next) {
    int at = first;
    while (at < next && !tokens.is(at, ":")) {
      at++;
    }
    return at;
  }

  /** Returns the offset after the name. */
  int nameEnd() {
    return name.isEmpty() ? nameStart + keyword.length() : nameStart + name.length();
  }
}
