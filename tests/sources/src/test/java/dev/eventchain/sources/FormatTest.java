package dev.eventchain.sources;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.google.googlejavaformat.java.Formatter;
import com.google.googlejavaformat.java.FormatterException;
import com.google.googlejavaformat.java.ImportOrderer;
import com.google.googlejavaformat.java.JavaFormatterOptions.Style;
import com.google.googlejavaformat.java.RemoveUnusedImports;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

/** Tests that all Java is formatted, as {@code mvn spotless:apply@format -N} formats it. */
class FormatTest {

  private static final Formatter FORMATTER = new Formatter();

  @Test
  void allJavaIsFormatted() throws IOException {
    List<Path> others =
        SourceFiles.ofJava().parallelStream().filter(file -> !isFormatted(file)).toList();
    assertEquals(List.of(), others, "mvn spotless:apply@format -N formats these");
  }

  private static boolean isFormatted(Path file) {
    try {
      String text = Files.readString(file);
      String formatted = RemoveUnusedImports.removeUnusedImports(FORMATTER.formatSource(text));
      return ImportOrderer.reorderImports(formatted, Style.GOOGLE).equals(text);
    } catch (FormatterException e) {
      return false;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
