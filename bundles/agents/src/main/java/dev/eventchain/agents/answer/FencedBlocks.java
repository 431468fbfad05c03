package dev.eventchain.agents.answer;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The fenced code blocks of a Markdown text.
 *
 * @param all the blocks in their order
 */
record FencedBlocks(List<FencedBlocks.Block> all) {
  private static final Pattern OPENING =
      Pattern.compile("^ {0,3}(`{3,}|~{3,})\\s*([\\w+#.-]*)[^`]*$");

  /**
   * One block.
   *
   * @param language its tag in lower case, or empty
   * @param text the content between the fences
   * @param closed true if the closing fence exists
   */
  record Block(String language, String text, boolean closed) {}

  static FencedBlocks in(String text) {
    List<Block> blocks = new ArrayList<>();
    String fence = null;
    String language = "";
    List<String> content = new ArrayList<>();
    for (String line : text.split("\n", -1)) {
      Matcher opening = OPENING.matcher(line);
      if (fence != null) {
        if (closes(line, fence)) {
          blocks.add(new Block(language, String.join("\n", content), true));
          fence = null;
        } else {
          content.add(line);
        }
      } else if (opening.matches()) {
        fence = opening.group(1);
        language = opening.group(2).toLowerCase(Locale.ROOT);
        content.clear();
      }
    }
    if (fence != null) {
      blocks.add(new Block(language, String.join("\n", content), false));
    }
    return new FencedBlocks(List.copyOf(blocks));
  }

  private static boolean closes(String line, String fence) {
    String bare = line.strip();
    return bare.startsWith(fence) && bare.chars().allMatch(c -> c == fence.charAt(0));
  }

  /**
   * Returns the blocks that may hold an artefact, without duplicates: those with a matching tag,
   * else those without a tag.
   */
  List<Block> candidates(AnswerKind kind) {
    List<Block> tagged = distinct(all.stream().filter(b -> kind.isLanguage(b.language())).toList());
    return tagged.isEmpty()
        ? distinct(all.stream().filter(b -> b.language().isEmpty()).toList())
        : tagged;
  }

  private static List<Block> distinct(List<Block> blocks) {
    List<Block> result = new ArrayList<>();
    for (Block block : blocks) {
      boolean known = result.stream().anyMatch(b -> b.text().strip().equals(block.text().strip()));
      if (!known && !block.text().isBlank()) {
        result.add(block);
      }
    }
    return result;
  }
}
