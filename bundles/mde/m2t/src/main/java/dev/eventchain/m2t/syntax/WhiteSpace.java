package dev.eventchain.m2t.syntax;

import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;

/**
 * Normaliser of the white space around tags, run once for a template. The rules were observed in
 * Acceleo 3.7.11. The {@link Role} of a tag selects the rules:
 *
 * <ul>
 *   <li>A tag takes the <b>rest of its line</b> with the line break if that is blank: {@link
 *       #takenBehind}.
 *   <li>A tag takes the <b>indentation</b> before it, if nothing but white space is between it and
 *       the tag or the line break before ({@link #takenBefore}).
 *   <li>A template's <b>last line break</b> is dropped ({@link #withoutLastBreak}).
 * </ul>
 *
 * The rules only consider two adjacent tags and the text between them: the tag before cuts its
 * start, and the tag after cuts its end.
 */
final class WhiteSpace {
  /** Treatment of the white space around a tag. */
  private enum Role {
    /** An expression, or a tag of a block on one line: takes nothing, like text. */
    SPEAKING,
    /**
     * A comment, or a tag of an empty block on one line. Takes the rest of its line if its line
     * starts blank; takes the indentation before it unless a speaking tag follows.
     */
    SILENT,
    /** Ends a block on one line with white space: takes the rest of its line like a silent tag. */
    TRAILING,
    /** Begins a body over several lines: takes the rest of its line and the indentation. */
    BEGINNING,
    /**
     * Ends a block over several lines. Takes the indentation, and the rest of its line if that
     * starts blank, or if it is nothing but white space up to the next tag.
     */
    ENDING,
    /** A tag of a protected area over several lines: a line of the output without indentation. */
    AREA;

    boolean takesIndentation() {
      return this == BEGINNING || this == ENDING || this == AREA;
    }
  }

  private final String source;
  private final List<Token> tokens;
  private final Role[] roles;

  /** True for each tag whose line starts blank, with only white space and silent tags. */
  private final boolean[] startsBlank;

  private WhiteSpace(String source, List<Token> tokens) {
    this.source = source;
    this.tokens = tokens;
    this.roles = new Role[tokens.size()];
    this.startsBlank = new boolean[tokens.size()];
  }

  /**
   * Returns the output of each text token with its offset.
   *
   * @param tokens balanced tokens
   * @return the text of each token; empty for tags
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

  /** Returns the length of the text after a tag that it takes. */
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

  /** Returns the offset from which the text before a tag is taken. */
  private int takenBefore(int tag, String text) {
    int indentation = text.lastIndexOf('\n') + 1;
    boolean takes =
        roles[tag].takesIndentation() || (roles[tag] == Role.SILENT && !isBeforeSpeaking(tag));
    return takes && text.substring(indentation).isBlank() ? indentation : text.length();
  }

  /**
   * Returns whether a sequence of silent tags, starting at this one, is directly followed by a
   * speaking tag.
   */
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
   * Returns the end of a template's final text without its last line break. If the text is just two
   * breaks, only one is dropped: the last one stays if the tag before took the first.
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

  /** Sets the roles of a block's tags, after those of its inner blocks. */
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

  /** Returns whether a block contains only silent tags and its own. */
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
   * Notes which tags are on a line that starts blank. The line of a body's first text always counts
   * as such: it is treated as the rest of the line of the tag that begins the body.
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

  /** Returns whether the line is blank so far, after a text. */
  private boolean isBlankBehind(int index, boolean before) {
    Token token = tokens.get(index);
    String text = source.substring(token.start(), token.end());
    int line = text.lastIndexOf('\n') + 1;
    boolean begins = index > 0 && roles[index - 1] == Role.BEGINNING;
    return line == 0 ? before && text.isBlank() : begins || text.substring(line).isBlank();
  }
}
