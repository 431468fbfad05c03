package dev.eventchain.sources;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests that Javadoc and docstrings of the code that ships begin with a noun phrase or a verb:
 * "What a road is" leaves readers to guess which noun is meant.
 */
class DescriptionsTest {

  /** First word of a description. */
  private static final Pattern BEGINNING =
      Pattern.compile("(?:/\\*\\*\\s+(?:\\*\\s+)?|\"\"\")([A-Z]\\w*)");

  private static final List<String> QUESTIONS =
      List.of("How", "What", "When", "Where", "Whether", "Which", "Who", "Why");

  @ParameterizedTest
  @ValueSource(strings = {".java", ".py"})
  void noneBeginsWithAQuestionWord(String suffix) throws IOException {
    List<String> questions = new ArrayList<>();
    int descriptions = 0;
    for (Path source : SourceFiles.ofBundles(suffix)) {
      String text = Files.readString(source);
      Matcher beginning = BEGINNING.matcher(text);
      while (beginning.find()) {
        descriptions++;
        if (QUESTIONS.contains(beginning.group(1))) {
          long line = text.substring(0, beginning.start(1)).lines().count();
          questions.add(source.getFileName() + ":" + line);
        }
      }
    }
    assertTrue(descriptions > 100, "only " + descriptions);
    assertEquals(List.of(), questions);
  }
}
