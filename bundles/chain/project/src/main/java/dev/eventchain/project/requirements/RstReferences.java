package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * The files that texts in reStructuredText name by {@code include} and {@code toctree}, found
 * without reading the texts: also those that a comment names.
 */
final class RstReferences {

  private static final Pattern INCLUDE = Pattern.compile("\\s*\\.\\. include::\\s+(\\S.*)");
  private static final Pattern TREE = Pattern.compile("\\s*\\.\\. toctree::.*");
  private static final Pattern TITLED = Pattern.compile("[^<>]*<([^<>]+)>");
  private static final List<String> SUFFIXES = List.of(".rst", ".md");

  /** Greatest number of files that are looked through. */
  private static final int MOST = 10_000;

  private final TextFolders folders;
  private final Set<Path> files = new LinkedHashSet<>();
  private final Set<Path> included = new LinkedHashSet<>();

  /** Finds the files that texts name, and those that these name, and so on. */
  RstReferences(Collection<Path> texts, TextFolders folders) {
    this.folders = folders;
    Deque<Path> open = new ArrayDeque<>(texts);
    Set<Path> seen = new LinkedHashSet<>(texts);
    while (!open.isEmpty() && seen.size() <= MOST) {
      Path text = open.pop();
      named(text).stream().filter(seen::add).forEach(open::add);
    }
    files.addAll(seen);
  }

  /** Returns the texts, and after them all files that they name, which need not exist. */
  Set<Path> files() {
    return files;
  }

  /** Returns the files that another one may take in. */
  Set<Path> included() {
    return included;
  }

  private List<Path> named(Path text) {
    if (SourceFiles.has(text, ".md") || !Files.isRegularFile(text)) {
      return List.of();
    }
    try {
      List<Path> found = new ArrayList<>();
      int tree = -1;
      for (String line : SourceText.read(text).text().lines().toList()) {
        Matcher include = INCLUDE.matcher(line);
        if (include.matches()) {
          Optional<Path> part = folders.find(text, include.group(1).strip());
          part.ifPresent(found::add);
          part.ifPresent(included::add);
        } else if (TREE.matcher(line).matches()) {
          tree = TextBlocks.indent(line);
        } else if (!line.isBlank() && TextBlocks.indent(line) <= tree) {
          tree = -1;
        } else if (tree >= 0) {
          document(line).ifPresent(name -> found.addAll(documents(text, name)));
        }
      }
      return found;
    } catch (DiagnosticException e) {
      return List.of(); // Reading it says why.
    }
  }

  /** Returns the name in a line of a tree; empty if the line names no document of the project. */
  static Optional<String> document(String line) {
    String text = line.strip();
    Matcher titled = TITLED.matcher(text);
    String name = titled.matches() ? titled.group(1).strip() : text;
    boolean isOther =
        name.isEmpty() || name.startsWith(":") || name.equals("self") || name.contains("://");
    return isOther ? Optional.empty() : Optional.of(name);
  }

  private List<Path> documents(Path text, String name) {
    return candidates(name).flatMap(each -> folders.find(text, each).stream()).toList();
  }

  /** Returns the names of files that a document may have. */
  static Stream<String> candidates(String name) {
    return SUFFIXES.stream().anyMatch(name::endsWith)
        ? Stream.of(name)
        : SUFFIXES.stream().map(suffix -> name + suffix);
  }
}
