package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileReads;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Properties;
import java.util.TreeMap;

/** Java properties files, in ISO 8859-1 with escapes. */
final class PropertyFiles {

  private PropertyFiles() {}

  /**
   * Returns the properties of files by their names without folders, in the order of the files.
   *
   * @throws DiagnosticException INPUT for a file that is missing, cannot be read or has a broken
   *     escape, and for a second one of the same name, since templates could not distinguish them
   */
  static Map<String, Map<String, String>> read(List<Path> files) {
    Map<String, Map<String, String>> all = new LinkedHashMap<>();
    for (Path file : files) {
      if (all.put(file.getFileName().toString(), read(file)) != null) {
        throw refused(
            PipelineRules.PROPERTIES_DUPLICATE, "Another properties file has this name.", file);
      }
    }
    return all;
  }

  private static Map<String, String> read(Path file) {
    FileReads.note(file);
    if (!Files.exists(file)) {
      throw refused(FileRules.MISSING, "There is no such properties file.", file);
    }
    Properties properties = new Properties();
    try (InputStream stream = Files.newInputStream(file)) {
      properties.load(stream);
    } catch (IOException e) {
      throw FileRules.refusal("The file", file, e);
    } catch (IllegalArgumentException e) {
      throw refused(FileRules.UNREADABLE, "The file has a broken escape: " + e.getMessage(), file);
    }
    Map<String, String> sorted = new TreeMap<>();
    properties.stringPropertyNames().forEach(key -> sorted.put(key, properties.getProperty(key)));
    return sorted;
  }

  private static DiagnosticException refused(Rule rule, String message, Path file) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.of(rule, message, SourceLocation.of(file)));
  }
}
