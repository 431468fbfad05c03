package dev.eventchain.m2t.syntax;

import dev.eventchain.m2t.syntax.Token.Kind;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/**
 * Decides what of the white space around tags is output, once for a template:
 *
 * <ul>
 *   <li>a line that holds only comments and tags of blocks disappears with its line break;
 *   <li>a block over several lines swallows the rest of its opening line and the indentation of its
 *       tags; a block on one line keeps everything;
 *   <li>the tags of a protected area stand for text, so nothing around them is swallowed.
 * </ul>
 */
final class WhiteSpace {
  /** A piece of text on the line that is being read, or a tag. */
  private record Part(int token, int from, int to, boolean tag) {}

  private final String text;
  private final List<Token> tokens;
  private final int[] starts;
  private final int[] ends;
  private final Set<Integer> swallowing;

  private WhiteSpace(String text, List<Token> tokens) {
    this.text = text;
    this.tokens = tokens;
    this.starts = tokens.stream().mapToInt(Token::start).toArray();
    this.ends = tokens.stream().mapToInt(Token::end).toArray();
    this.swallowing = tagsOfBlocksOverSeveralLines();
  }

  /**
   * The output of each token that is text, and where it starts.
   *
   * @param tokens balanced tokens
   * @return for each token its text; empty for tags
   */
  static List<Syntax.Text> normalise(String text, List<Token> tokens) {
    WhiteSpace whiteSpace = new WhiteSpace(text, tokens);
    whiteSpace.walkLines();
    List<Syntax.Text> texts = new ArrayList<>(tokens.size());
    for (int i = 0; i < tokens.size(); i++) {
      boolean keeps =
          tokens.get(i).kind() == Kind.TEXT && whiteSpace.starts[i] < whiteSpace.ends[i];
      int start = whiteSpace.starts[i];
      texts.add(new Syntax.Text(start, keeps ? text.substring(start, whiteSpace.ends[i]) : ""));
    }
    return texts;
  }

  /** Drops the last line break of a template, unless its final text is just two of them. */
  static String withoutLastBreak(String finalText) {
    if (finalText.equals("\n\n") || finalText.equals("\r\n\r\n")) {
      return finalText;
    }
    if (finalText.endsWith("\r\n")) {
      return finalText.substring(0, finalText.length() - 2);
    }
    return finalText.endsWith("\n") ? finalText.substring(0, finalText.length() - 1) : finalText;
  }

  private Set<Integer> tagsOfBlocksOverSeveralLines() {
    Set<Integer> found = new HashSet<>();
    Deque<List<Integer>> open = new ArrayDeque<>();
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      if (token.kind() == Kind.OPEN) {
        open.push(new ArrayList<>());
      }
      if (token.isBlockTag() && !open.isEmpty()) {
        open.peek().add(i);
      }
      if (token.kind() == Kind.CLOSE && !open.isEmpty()) {
        List<Integer> tags = open.pop();
        int from = tokens.get(tags.get(0)).end();
        boolean severalLines = text.substring(from, token.start()).indexOf('\n') >= 0;
        if (severalLines && !token.keyword().equals("protected")) {
          found.addAll(tags);
        }
      }
    }
    return found;
  }

  private void walkLines() {
    List<Part> line = new ArrayList<>();
    for (int i = 0; i < tokens.size(); i++) {
      Token token = tokens.get(i);
      if (token.kind() != Kind.TEXT) {
        line.add(new Part(i, token.start(), token.end(), true));
        continue;
      }
      int first = text.indexOf('\n', token.start());
      if (first < 0 || first >= token.end()) {
        line.add(new Part(i, token.start(), token.end(), false));
        continue;
      }
      line.add(new Part(i, token.start(), first + 1, false));
      normalise(line);
      line.clear();
      int last = text.lastIndexOf('\n', token.end() - 1);
      line.add(new Part(i, last + 1, token.end(), false));
    }
    normalise(line);
  }

  private void normalise(List<Part> line) {
    if (line.stream().noneMatch(part -> part.tag())) {
      return;
    }
    if (line.stream().allMatch(this::vanishes) && line.stream().anyMatch(this::takesItsLine)) {
      swallow(line);
      return;
    }
    for (int i = 0; i < line.size(); i++) {
      if (!swallowing.contains(line.get(i).token())) {
        continue;
      }
      List<Part> before = line.subList(0, i);
      if (before.stream().allMatch(this::vanishes)) {
        swallow(before);
      }
      List<Part> after = line.subList(i + 1, line.size());
      boolean opens = tokens.get(line.get(i).token()).kind() != Kind.CLOSE;
      if (opens && after.stream().allMatch(this::vanishes)) {
        swallow(after);
      }
    }
  }

  /** Whether a part puts nothing but white space on its line. */
  private boolean vanishes(Part part) {
    Token token = tokens.get(part.token());
    if (part.tag()) {
      return token.kind() == Kind.COMMENT
          || (token.isBlockTag() && !token.keyword().equals("protected"));
    }
    return text.substring(part.from(), part.to()).isBlank();
  }

  private boolean takesItsLine(Part part) {
    return tokens.get(part.token()).kind() == Kind.COMMENT || swallowing.contains(part.token());
  }

  private void swallow(List<Part> parts) {
    for (Part part : parts) {
      if (!part.tag()) {
        int token = part.token();
        if (part.from() <= starts[token]) {
          starts[token] = Math.max(starts[token], part.to());
        } else {
          ends[token] = Math.min(ends[token], part.from());
        }
      }
    }
  }
}
