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

  /** Documents that Sphinx makes itself, and that projects name like their own. */
  private static final Set<String> MADE = Set.of("self", "genindex", "modindex", "search");

  /** Greatest number of files that are looked through. */
  private static final int MOST = 10_000;

  private final TextFolders folders;
  private final Set<Path> files = new LinkedHashSet<>();
  private final Set<Path> included = new LinkedHashSet<>();

  /** Finds the files that texts name, and those that these name, and so on. */
  RstReferences(Collection<Path> texts, TextFolders folders) {
    this.folders = folders;
    Set<Named> seen = new LinkedHashSet<>();
    texts.forEach(text -> seen.add(new Named(text, text)));
    Deque<Named> open = new ArrayDeque<>(seen);
    while (!open.isEmpty() && seen.size() <= MOST) {
      named(open.pop()).stream().filter(seen::add).forEach(open::add);
    }
    seen.forEach(each -> files.add(each.file()));
  }

  /** A file, and the document that takes it in, which is itself where none does. */
  private record Named(Path file, Path document) {}

  /** Returns the texts, and after them all files that they name, which need not exist. */
  Set<Path> files() {
    return files;
  }

  /** Returns the files that another one may take in. */
  Set<Path> included() {
    return included;
  }

  private List<Named> named(Named text) {
    if (SourceFiles.has(text.file(), ".md") || !Files.isRegularFile(text.file())) {
      return List.of();
    }
    try {
      List<Named> found = new ArrayList<>();
      int tree = -1;
      for (String line : SourceText.read(text.file()).text().lines().toList()) {
        Matcher include = INCLUDE.matcher(line);
        if (include.matches()) {
          for (Path part : find(text, include.group(1).strip())) {
            found.add(new Named(part, text.document()));
            included.add(part);
          }
        } else if (TREE.matcher(line).matches()) {
          tree = TextBlocks.indent(line);
        } else if (!line.isBlank() && TextBlocks.indent(line) <= tree) {
          tree = -1;
        } else if (tree >= 0) {
          document(line).stream()
              .flatMap(RstReferences::candidates)
              .flatMap(name -> find(text, name).stream())
              .forEach(each -> found.add(new Named(each, each)));
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
        name.isEmpty() || name.startsWith(":") || MADE.contains(name) || name.contains("://");
    return isOther ? Optional.empty() : Optional.of(name);
  }

  /** Returns the files that a name in a file may stand for, see {@link RstFiles}. */
  private List<Path> find(Named text, String name) {
    return Stream.of(text.file(), text.document())
        .flatMap(each -> folders.find(each, name).stream())
        .toList();
  }

  /** Returns the names of files that a document may have. */
  static Stream<String> candidates(String name) {
    return SUFFIXES.stream().anyMatch(name::endsWith)
        ? Stream.of(name)
        : SUFFIXES.stream().map(suffix -> name + suffix);
  }
}
