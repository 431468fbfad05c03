package dev.eventchain.project.requirements;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;

/** The files that texts in reStructuredText take in or name as further documents. */
final class RstFiles {

  /** Greatest number of files in each other. */
  private static final int DEEPEST = 20;

  /** Greatest number of times that a file is taken in. */
  private static final int MOST = 1_000;

  private final Reading reading;
  private final TextFolders folders;
  private final Set<Path> documents = new LinkedHashSet<>();
  private final Set<Path> included = new HashSet<>();
  private int times;
  private long length;

  RstFiles(Reading reading, TextFolders folders) {
    this.reading = reading;
    this.folders = folders;
  }

  /**
   * A file while it is read.
   *
   * @param open the files that take it in, and itself
   */
  record Open(SourceText source, List<Path> open) {

    Open(SourceText source, Path file) {
      this(source, List.of(file));
    }

    Path file() {
      return open.get(open.size() - 1);
    }

    /** Returns the outermost file. */
    Path document() {
      return open.get(0);
    }
  }

  /** Returns the documents that texts name, in their order. */
  Set<Path> documents() {
    return documents;
  }

  /** Returns whether a file was taken in by another one, all of it. */
  boolean isIncluded(Path file) {
    return included.contains(file);
  }

  /** Returns the file that another one takes in; empty with a finding if it is not read. */
  Optional<Open> include(Open from, String name, SourceLocation place) {
    Optional<Path> found = find(from, name);
    if (found.isEmpty()) {
      outside(name, place);
    } else if (from.open().contains(found.get())) {
      reading.unread(
          "This file takes itself in, which is not read again.",
          place,
          "Take the directive out.",
          RequirementRules.UNREAD);
    } else if (!Files.isRegularFile(found.get())) {
      reading.unread("There is no file '" + name + "'.", place, "Correct its name, or add it.");
    } else {
      return open(from, found.get(), place);
    }
    return Optional.empty();
  }

  /**
   * Returns the file that a name stands for: from the file that has it, as in docutils, or else
   * from the document that takes that in, as in Sphinx.
   */
  private Optional<Path> find(Open from, String name) {
    List<Path> found =
        Stream.of(from.file(), from.document())
            .flatMap(each -> folders.find(each, name).stream())
            .toList();
    return found.stream()
        .filter(Files::isRegularFile)
        .findFirst()
        .or(() -> found.stream().findFirst());
  }

  private Optional<Open> open(Open from, Path file, SourceLocation place) {
    List<Path> open = new ArrayList<>(from.open());
    open.add(file);
    Optional<SourceText> read = Reading.file(file, reading, Optional::of);
    length += read.map(text -> text.text().length()).orElse(0);
    if (open.size() > DEEPEST || ++times > MOST || length > Reading.LONGEST) {
      throw Reading.refused(
          String.format(
              Locale.ROOT,
              "More than %d files are in each other, %d in all, or %d characters.",
              DEEPEST,
              MOST,
              Reading.LONGEST),
          place,
          "Take some of them out.");
    }
    return read.map(text -> new Open(text, open));
  }

  /** Keeps a document that a tree names, with a finding if there is none. */
  void document(Open from, String name, SourceLocation place) {
    List<Path> found =
        RstReferences.candidates(name).flatMap(each -> find(from, each).stream()).toList();
    Optional<Path> file = found.stream().filter(Files::isRegularFile).findFirst();
    if (found.isEmpty()) {
      outside(name, place);
    } else if (file.isEmpty() && !folders.isRead(from.file(), name)) {
      reading.unread(
          "There is no document '" + name + "', so that nothing of it is read.",
          place,
          "Correct its name, or add NAME.rst or NAME.md. Patterns are not read: name each one.",
          RequirementRules.UNREAD);
    }
    file.ifPresent(documents::add);
  }

  private void outside(String name, SourceLocation place) {
    reading.unread(
        "'%s' is outside of the folders of the project and of this source, and is not read."
            .formatted(name),
        place,
        "If it has requirements, name it in eventchain.yaml.",
        RequirementRules.UNREAD);
  }

  /**
   * Returns what a directive takes in of a file: first lines are cut, and then texts are looked for
   * in what is left, as docutils does; empty with a finding if one is not there.
   */
  Optional<Part> part(Open file, Map<String, String> options, SourceLocation place) {
    SourceText source = file.source();
    int lines = TextItems.lines(source).size();
    int first = number(options, "start-line", 0, lines);
    int last = Math.max(first, number(options, "end-line", lines, lines));
    int from = offset(source, first);
    int to = offset(source, last);
    String after = options.getOrDefault("start-after", "");
    int begin = after.isEmpty() ? from : found(source, after, from, to, place);
    if (begin < 0) {
      return Optional.empty();
    }
    from = begin + after.length();
    String until = options.getOrDefault("end-before", "");
    to = until.isEmpty() ? to : found(source, until, from, to, place);
    if (to < 0) {
      return Optional.empty();
    }
    if (from == 0 && to == source.text().length()) {
      included.add(file.file());
    }
    return Optional.of(
        new Part(source.text().substring(from, to).lines().toList(), source.at(from).line() - 1));
  }

  private static int offset(SourceText source, int before) {
    String text = source.text();
    int offset = 0;
    for (int i = 0; i < before && offset < text.length(); i++) {
      int end = offset;
      while (end < text.length() && "\r\n".indexOf(text.charAt(end)) < 0) {
        end++;
      }
      boolean isPair = text.startsWith("\r\n", end);
      offset = Math.min(text.length(), end + (isPair ? 2 : 1));
    }
    return offset;
  }

  /** Returns where a text is between two offsets; -1 with a finding if it is not there. */
  private int found(SourceText source, String text, int from, int to, SourceLocation place) {
    int at = source.text().indexOf(text, from);
    if (at < 0 || at + text.length() > to) {
      reading.unread(
          "The file has no text '" + text + "', from which or up to which it is taken in.",
          place,
          "Write the text as it is in the file.");
      return -1;
    }
    return at;
  }

  /** Lines of a file, and the number of lines in front of them. */
  record Part(List<String> lines, int before) {}

  private static int number(Map<String, String> options, String name, int usual, int most) {
    String value = options.getOrDefault(name, "");
    if (!value.matches("-?[0-9]{1,9}")) {
      return usual;
    }
    int number = Integer.parseInt(value);
    return Math.max(0, Math.min(number < 0 ? most + number : number, most));
  }
}
