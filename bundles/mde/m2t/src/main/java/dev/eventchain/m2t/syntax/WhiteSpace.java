package dev.eventchain.m2t.syntax;

import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * Decides what of the white space around tags is output, once for a template. The rules are those
 * that Acceleo 3.7.11 was seen to follow. A tag's {@link Role} says which of them hold for it:
 *
 * <ul>
 *   <li>A tag takes the <b>rest of its line</b> after it, with the line break, if nothing but white
 *       space is there ({@link #takenBehind}).
 *   <li>A tag takes the <b>indentation</b> before it, if nothing but white space is between it and
 *       the tag or the line break before ({@link #takenBefore}).
 *   <li>A template's <b>last line break</b> is dropped ({@link #withoutLastBreak}).
 * </ul>
 *
 * What is between two tags is one text, and no rule looks beyond the two: a text is cut at its
 * start by the tag before it, and at its end by the tag after it.
 */
final class WhiteSpace {
  /** How a tag treats the white space around it. */
  private enum Role {
    /** An expression, or a tag of a block on one line: takes nothing, as the text it stands for. */
    SPEAKING,
    /**
     * A comment, or a tag of a block on one line with nothing in it. Takes the rest of its line if
     * its line starts blank; takes the indentation before it unless an expression, or the like, is
     * what that indents.
     */
    SILENT,
    /** Ends a block on one line with white space: takes the rest of its line as a silent one. */
    TRAILING,
    /** Begins a body over several lines: takes the rest of its line and the indentation. */
    BEGINNING,
    /**
     * Ends a block over several lines. Takes the indentation, and the rest of its line if that
     * starts blank, or if it is nothing but white space up to the next tag.
     */
    ENDING,
    /** A tag of a protected area over several lines: a line of the output, with no indentation. */
    AREA;

    boolean takesIndentation() {
      return this == BEGINNING || this == ENDING || this == AREA;
    }
  }

  private final String source;
  private final List<Token> tokens;
  private final Role[] roles;

  /** For each tag, whether its line starts blank: with nothing but white space and silent tags. */
  private final boolean[] startsBlank;

  private WhiteSpace(String source, List<Token> tokens) {
    this.source = source;
    this.tokens = tokens;
    this.roles = new Role[tokens.size()];
    this.startsBlank = new boolean[tokens.size()];
  }

  /**
   * The output of each token that is text, and where it starts.
   *
   * @param tokens balanced tokens
   * @return for each token its text; empty for tags
   */
  static List<Syntax.Text> normalise(String source, List<Token> tokens) {
    WhiteSpace whiteSpace = new WhiteSpace(source, tokens);
    whiteSpace.findRoles();
    whiteSpace.findBlankStarts();
    List<Syntax.Text> texts = new ArrayList<>(tokens.size());
    for (int i = 0; i < tokens.size(); i++) {
      texts.add(
          tokens.get(i).kind() == Kind.TEXT
              ? whiteSpace.text(i)
              : new Syntax.Text(tokens.get(i).start(), ""));
    }
    return texts;
  }

  private Syntax.Text text(int index) {
    Token token = tokens.get(index);
    String whole = source.substring(token.start(), token.end());
    int from = index == 0 ? 0 : takenBehind(index - 1, whole);
    boolean last = index + 1 == tokens.size();
    int to = last ? whole.length() : Math.max(from, takenBefore(index + 1, whole));
    if (!last && endsTemplate(index + 1)) {
      to = withoutLastBreak(whole, from, to);
    }
    return new Syntax.Text(token.start() + from, whole.substring(from, to));
  }

  /** How much of the text after a tag goes with it. */
  private int takenBehind(int tag, String text) {
    Role role = roles[tag];
    int rest = text.indexOf('\n') + 1;
    boolean alone = rest > 0 && text.substring(0, rest).isBlank();
    return switch (role) {
      case BEGINNING -> alone ? rest : 0;
      case SILENT, TRAILING -> alone && startsBlank[tag] ? rest : 0;
      case ENDING -> !startsBlank[tag] ? 0 : alone ? rest : text.isBlank() ? text.length() : 0;
      case SPEAKING, AREA -> 0;
    };
  }

  /** Where the part of the text before a tag starts that goes with it. */
  private int takenBefore(int tag, String text) {
    int indentation = text.lastIndexOf('\n') + 1;
    boolean takes =
        roles[tag].takesIndentation() || (roles[tag] == Role.SILENT && !isBeforeSpeaking(tag));
    return takes && text.substring(indentation).isBlank() ? indentation : text.length();
  }

  /** Whether silent tags, of which this is the first, end where a speaking tag starts. */
  private boolean isBeforeSpeaking(int tag) {
    int next = tag;
    while (next < tokens.size() && roles[next] == Role.SILENT) {
      next++;
    }
    return next < tokens.size()
        && tokens.get(next).kind() != Kind.TEXT
        && !roles[next].takesIndentation();
  }

  private boolean endsTemplate(int index) {
    Token token = tokens.get(index);
    return roles[index] == Role.ENDING && token.keyword().equals("template");
  }

  /**
   * The end of a template's final text without its last line break. Of a text of just two breaks
   * only one goes in all: the last one stays if the tag before took the first.
   */
  private static int withoutLastBreak(String text, int from, int to) {
    String kept = text.substring(0, to);
    boolean two = kept.equals("\n\n") || kept.equals("\r\n\r\n");
    if (to <= from || text.charAt(to - 1) != '\n' || (two && from > 0)) {
      return to;
    }
    boolean wide = to - 1 > from && text.charAt(to - 2) == '\r';
    return wide ? to - 2 : to - 1;
  }

  private void findRoles() {
    Deque<List<Integer>> open = new ArrayDeque<>();
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      roles[i] = token.kind() == Kind.COMMENT ? Role.SILENT : Role.SPEAKING;
      if (token.kind() == Kind.OPEN) {
        open.push(new ArrayList<>());
      }
      if (token.isBlockTag() && !open.isEmpty()) {
        open.peek().add(i);
      }
      if (token.kind() == Kind.CLOSE && !open.isEmpty()) {
        findRoles(open.pop());
      }
    }
  }

  /** The roles of a block's tags, of which the blocks inside have theirs already. */
  private void findRoles(List<Integer> tags) {
    int first = tags.get(0);
    int last = tags.get(tags.size() - 1);
    boolean overLines =
        source.substring(tokens.get(first).end(), tokens.get(last).start()).indexOf('\n') >= 0;
    boolean area = tokens.get(first).keyword().equals("protected");
    if (overLines) {
      tags.forEach(tag -> roles[tag] = area ? Role.AREA : Role.BEGINNING);
      roles[last] = area ? Role.AREA : Role.ENDING;
    } else if (!area && isEmpty(first, last)) {
      tags.forEach(tag -> roles[tag] = Role.SILENT);
    } else if (!area && tokens.get(last - 1).kind() == Kind.TEXT && isBlank(last - 1)) {
      roles[last] = Role.TRAILING;
    }
  }

  /** Whether there is nothing in a block but silent tags, and its own. */
  private boolean isEmpty(int first, int last) {
    for (int i = first + 1; i < last; i++) {
      Token token = tokens.get(i);
      if (token.kind() != Kind.MIDDLE && roles[i] != Role.SILENT) {
        return false;
      }
    }
    return true;
  }

  private boolean isBlank(int index) {
    return source.substring(tokens.get(index).start(), tokens.get(index).end()).isBlank();
  }

  /**
   * Walks through the tags and notes which of them are on a line that starts blank. So does the
   * line of a body's first text, whatever it says: it is taken for the rest of the line of the tag
   * that begins the body.
   */
  private void findBlankStarts() {
    Deque<Boolean> open = new ArrayDeque<>();
    boolean blank = true;
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      if (token.kind() == Kind.OPEN) {
        open.push(blank);
      }
      boolean closes = token.kind() == Kind.CLOSE && !open.isEmpty();
      boolean outside = closes ? open.pop() : blank;
      blank = roles[i] == Role.TRAILING ? outside : blank;
      startsBlank[i] = blank;
      blank =
          token.kind() == Kind.TEXT
              ? isBlankBehind(i, blank)
              : roles[i] == Role.BEGINNING || (blank && !speaks(i));
    }
  }

  private boolean speaks(int tag) {
    return roles[tag] == Role.SPEAKING || roles[tag] == Role.AREA;
  }

  /** Whether the line is blank after a text, so far. */
  private boolean isBlankBehind(int index, boolean before) {
    Token token = tokens.get(index);
    String text = source.substring(token.start(), token.end());
    int line = text.lastIndexOf('\n') + 1;
    boolean begins = index > 0 && roles[index - 1] == Role.BEGINNING;
    return line == 0 ? before && text.isBlank() : begins || text.substring(line).isBlank();
  }
}
