package dev.eventchain.pipeline;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.FileRules;
import dev.eventchain.diagnostics.Rule;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.zip.ZipFile;

/** The Java classes that templates may call, until closed. */
final class JavaServices implements AutoCloseable {

  private final Optional<URLClassLoader> loader;

  private JavaServices(Optional<URLClassLoader> loader) {
    this.loader = loader;
  }

  /**
   * Opens JARs and folders of classes; the program's own libraries, such as EMF, are visible to
   * them.
   *
   * @throws DiagnosticException INPUT for one that is missing ({@code file.missing}) or no JAR
   *     ({@code file.unreadable})
   */
  static JavaServices of(List<Path> places) {
    if (places.isEmpty()) {
      return new JavaServices(Optional.empty());
    }
    URL[] urls = places.stream().map(JavaServices::url).toArray(URL[]::new);
    return new JavaServices(
        Optional.of(new URLClassLoader(urls, JavaServices.class.getClassLoader())));
  }

  private static URL url(Path place) {
    if (!Files.exists(place)) {
      throw refused(FileRules.MISSING, "There is no such JAR or folder.", place);
    }
    try {
      if (!Files.isDirectory(place)) {
        new ZipFile(place.toFile()).close();
      }
      return place.toUri().toURL();
    } catch (MalformedURLException e) {
      throw new UncheckedIOException(e);
    } catch (IOException e) {
      throw refused(FileRules.UNREADABLE, "The file cannot be read as a JAR.", place);
    }
  }

  private static DiagnosticException refused(Rule rule, String message, Path place) {
    return new DiagnosticException(
        DiagnosticException.Reason.INPUT, Diagnostic.of(rule, message, SourceLocation.of(place)));
  }

  /** Returns the class loader; empty if there are no places. */
  Optional<ClassLoader> loader() {
    return loader.map(ClassLoader.class::cast);
  }

  @Override
  public void close() {
    if (loader.isPresent()) {
      try {
        loader.get().close();
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }
  }
}
