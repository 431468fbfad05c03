package dev.eventchain.documents;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Repository;
import java.io.IOException;
import java.nio.charset.MalformedInputException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Formatted YAML, and that it says what it said before. */
class YamlFormatterTest {

  private static final int RANDOM_TEXTS = 500;

  private static final String TEXT =
      """
      # A comment.
      a:   # of a

          # of b
          b:  1\s\s
          text: |
              two
                lines\s\s

          folded: >-
            words
            and more
          plain: words
             and more
          quoted: "with a  \\
             break"
          # of the list
          list:
          -   x: &anchor [1,
                 2]
              y: *anchor
          -   - 1
              -   2
          -
              z: {a: 1,
            b: 2}
      # the end


      """;

  private static final String FORMATTED =
      """
      # A comment.
      a:   # of a

        # of b
        b:  1
        text: |
            two
              lines\s\s

        folded: >-
          words
          and more
        plain: words
           and more
        quoted: "with a  \\
           break"
        # of the list
        list:
        - x: &anchor [1,
             2]
          y: *anchor
        - - 1
          - 2
        -
          z: {a: 1,
        b: 2}
      # the end
      """;

  @Test
  void linesMoveWithWhatTheyBelongTo() {
    assertEquals(Optional.of(FORMATTED), YamlFormatter.format(TEXT, 2));
    assertEquals(Optional.of(FORMATTED), YamlFormatter.format(FORMATTED, 2));
    assertTrue(YamlFormatter.saysTheSame(TEXT, FORMATTED));
  }

  @Test
  void lineBreaksStay() {
    assertEquals(
        Optional.of("a:\r\n    b: 1\r\n\r\n    c: 2\r\n"),
        YamlFormatter.format("a: \r\n  b: 1 \r\n  \r\n  c: 2", 4));
  }

  /** The last lines of a text in lines are part of it, and so is whether it ends with a break. */
  @ParameterizedTest
  @ValueSource(
      strings = {"a: |+\n  b\n\n\n", "a: |\n  b", "a: |2\n    b\n", "", "\n", "# no value\n"})
  void whatEndsInATextStays(String text) {
    assertEquals(Optional.of(text), YamlFormatter.format(text, 2));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "a: [1",
        "a:\n\tb: 1",
        "? a\n: b\n",
        "a: 1\n b: 2",
        "a: 'x",
        "a: \u2028 1",
        "a:  *b"
      })
  void whatCannotBeReadIsLeftAlone(String text) {
    assertEquals(Optional.empty(), YamlFormatter.format(text, 2));
  }

  @Test
  void severalDocumentsStayOnes() {
    assertEquals(
        Optional.of("%YAML 1.1\n---\na:\n  b: 1\n---\n- 1\n...\n"),
        YamlFormatter.format("%YAML 1.1\n---\na:\n     b: 1\n---\n-  1\n...", 2));
  }

  @Test
  void theFilesHereSayTheSameAfterwards() throws IOException {
    int formatted = 0;
    try (Stream<Path> files =
        Files.find(
            Repository.ROOT,
            30,
            (path, is) ->
                path.toString().matches(".*\\.ya?ml") && !path.toString().contains("target"))) {
      for (Path file : files.sorted().toList()) {
        String text = text(file);
        for (int step : List.of(2, 3)) {
          Optional<String> found = YamlFormatter.format(text, step);
          found.ifPresent(each -> assertTrue(YamlFormatter.saysTheSame(text, each)));
          assertEquals(found, found.flatMap(each -> YamlFormatter.format(each, step)));
          formatted += found.isPresent() ? 1 : 0;
        }
      }
    }
    assertTrue(formatted > 800, formatted + " texts");
  }

  private static String text(Path file) throws IOException {
    try {
      return Files.readString(file);
    } catch (MalformedInputException e) {
      return "["; // a case of another test
    }
  }

  /** Any steps lead to the same text, since only the structure counts. */
  @Test
  void textsAtRandomAreFormattedAlike() {
    for (int seed = 0; seed < RANDOM_TEXTS; seed++) {
      String text = text(new Random(seed), 2, false);
      String other = text(new Random(seed), 2 + seed % 5, true);
      assertTrue(YamlFormatter.saysTheSame(text, other), other);
      assertEquals(Optional.of(text), YamlFormatter.format(other, 2), other);
      assertEquals(Optional.of(text), YamlFormatter.format(text, 2));
    }
  }

  private static String text(Random random, int step, boolean wide) {
    StringBuilder text = new StringBuilder();
    mapping(random, step, wide, 0, 0, text);
    return text.toString();
  }

  private static void mapping(
      Random random, int step, boolean wide, int column, int depth, StringBuilder text) {
    int keys = 1 + random.nextInt(3);
    for (int i = 0; i < keys; i++) {
      String indent = i == 0 && text.toString().endsWith("- ") ? "" : " ".repeat(column);
      text.append(indent).append("k").append(i).append(":");
      int kind = depth > 3 ? 0 : random.nextInt(4);
      String end = wide ? " \n" : "\n";
      if (kind == 0) {
        text.append(" v").append(random.nextInt(9)).append(end);
      } else if (kind == 1) {
        text.append(" |\n").append(" ".repeat(column + 2)).append("a  \n");
        text.append(" ".repeat(column + 3)).append("b\n");
      } else if (kind == 2) {
        text.append(end);
        mapping(random, step, wide, column + step, depth + 1, text);
      } else {
        text.append(end).append(" ".repeat(column)).append("# c\n");
        for (int j = random.nextInt(3); j >= 0; j--) {
          text.append(" ".repeat(column + step)).append("- ");
          mapping(random, step, wide, column + step + 2, depth + 1, text);
        }
      }
    }
  }
}
