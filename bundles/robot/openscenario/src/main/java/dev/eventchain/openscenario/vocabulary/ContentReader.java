package dev.eventchain.openscenario.vocabulary;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads the notation of contents: {@code Position (Deterministic | Stochastic)? Vertex{2,}}. */
final class ContentReader {

  private static final Pattern TOKEN = Pattern.compile("[A-Za-z0-9:]+|\\{\\d+,}|[()|?*+]");

  private final List<String> tokens = new ArrayList<>();
  private int next;

  private ContentReader(String notation) {
    Matcher token = TOKEN.matcher(notation);
    while (token.find()) {
      tokens.add(token.group());
    }
  }

  static Content read(String notation) {
    ContentReader reader = new ContentReader(notation);
    Content content = reader.group();
    if (reader.next < reader.tokens.size()) {
      throw new IllegalArgumentException(notation);
    }
    return content;
  }

  private Content group() {
    List<Content> parts = new ArrayList<>();
    boolean either = false;
    while (next < tokens.size() && !tokens.get(next).equals(")")) {
      if (tokens.get(next).equals("|")) {
        either = true;
        next++;
      }
      parts.add(part());
    }
    int[] numbers = {1, 1};
    if (next < tokens.size()) {
      next++;
      numbers = numbers();
    }
    return either
        ? new Content.Either(parts, numbers[0], numbers[1])
        : new Content.All(parts, numbers[0], numbers[1]);
  }

  private Content part() {
    String token = tokens.get(next++);
    if (token.equals("(")) {
      return group();
    }
    int colon = token.indexOf(':');
    String name = colon < 0 ? token : token.substring(0, colon);
    int[] numbers = numbers();
    return new Content.Child(name, token.substring(colon + 1), numbers[0], numbers[1]);
  }

  private int[] numbers() {
    String token = next < tokens.size() ? tokens.get(next) : "";
    int[] numbers =
        switch (token) {
          case "?" -> new int[] {0, 1};
          case "*" -> new int[] {0, Content.UNBOUNDED};
          case "+" -> new int[] {1, Content.UNBOUNDED};
          default ->
              token.startsWith("{")
                  ? new int[] {
                    Integer.parseInt(token.substring(1, token.length() - 2)), Content.UNBOUNDED
                  }
                  : new int[0];
        };
    if (numbers.length == 0) {
      return new int[] {1, 1};
    }
    next++;
    return numbers;
  }
}
