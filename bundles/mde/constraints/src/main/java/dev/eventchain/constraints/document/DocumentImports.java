package dev.eventchain.constraints.document;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The files that rule documents import: {@code import 'other.ocl'}. A path is relative to the
 * importing document. A URI, which names a place in a workspace, stands for the file of that name
 * next to the importing document.
 */
public final class DocumentImports {

  /** An import line: a URI, a file or a name. */
  public record Import(String target, SourceLocation location) {}

  private static final String EXTENSION = ".ocl";

  private DocumentImports() {}

  /** Returns the files and then those that they import, each once. */
  public static List<Path> files(List<Path> given) {
    List<Path> files = new ArrayList<>();
    Set<Path> seen = new HashSet<>();
    for (Path file : given) {
      if (seen.add(identity(file))) {
        files.add(file);
      }
    }
    for (int i = 0; i < files.size(); i++) {
      Path importer = files.get(i);
      SourceLocation place = SourceLocation.of(importer);
      for (Import each : DiagnosticException.at(place, () -> importsOf(importer))) {
        fileOf(each, importer)
            .filter(file -> Files.isRegularFile(file) && seen.add(identity(file)))
            .ifPresent(files::add);
      }
    }
    return files;
  }

  /** Returns the documents that a document names in its import lines, whether they exist or not. */
  public static List<Path> named(RuleDocument document, Path importer) {
    return document.imports().stream().flatMap(each -> fileOf(each, importer).stream()).toList();
  }

  private static List<Import> importsOf(Path document) {
    return RuleDocument.read(SourceText.read(document), new ArrayList<>()).imports();
  }

  /** Returns whether an import names one of the documents. */
  public static boolean names(Import wanted, List<String> documents) {
    Optional<Path> file = fileOf(wanted, Path.of(wanted.location().file()));
    return file.isPresent()
        && documents.stream()
            .anyMatch(each -> identity(Path.of(each)).equals(identity(file.get())));
  }

  /** Returns whether the target of an import is a rule document. */
  public static boolean isDocument(String target) {
    return target.endsWith(EXTENSION);
  }

  /** Returns the file that an import means; empty if that is no rule document. */
  private static Optional<Path> fileOf(Import wanted, Path importer) {
    String target = wanted.target();
    if (!isDocument(target)) {
      return Optional.empty();
    }
    boolean uri = target.matches("\\w[\\w+.-]+:.*");
    try {
      String path = uri ? target.substring(target.lastIndexOf('/') + 1) : target;
      return Optional.of(importer.resolveSibling(path).normalize());
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
  }

  private static Path identity(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      return file.toAbsolutePath().normalize();
    }
  }
}
