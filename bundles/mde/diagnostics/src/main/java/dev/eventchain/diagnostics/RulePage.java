package dev.eventchain.diagnostics;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.net.JarURLConnection;
import java.net.URI;
import java.net.URL;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.jar.JarFile;
import java.util.jar.Manifest;
import java.util.stream.Stream;

/**
 * Page that explains a diagnostic id. The jar of each bundle holds its pages in {@code rules/};
 * those of all jars on the class path are found.
 *
 * @param id the diagnostic id
 * @param bundle the bundle that reports it
 * @param text the page, in Markdown, with the id as its heading
 */
public record RulePage(String id, String bundle, String text) {

  private static final String FOLDER = "META-INF/eventchain/rules/";
  private static final String SUFFIX = ".md";
  private static final String UNSUPPRESSIBLE = "It cannot be suppressed.";

  /** Returns the page of an id, if a bundle on the class path has one. */
  public static Optional<RulePage> of(String id) {
    if (!id.matches("[a-z0-9]+([.-][a-z0-9]+)*")) {
      return Optional.empty();
    }
    URL resource = RulePage.class.getClassLoader().getResource(FOLDER + id + SUFFIX);
    return Optional.ofNullable(resource).map(found -> read(id, found));
  }

  /** Returns all pages, sorted by bundle and id. */
  public static List<RulePage> all() {
    List<RulePage> pages = new ArrayList<>();
    try {
      for (URL folder : Collections.list(RulePage.class.getClassLoader().getResources(FOLDER))) {
        for (String id : idsIn(folder)) {
          pages.add(read(id, URI.create(folder + id + SUFFIX).toURL()));
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    pages.sort(Comparator.comparing(RulePage::bundle).thenComparing(RulePage::id));
    return pages;
  }

  private static List<String> idsIn(URL folder) throws IOException {
    if (folder.openConnection() instanceof JarURLConnection connection) {
      JarFile jar = connection.getJarFile();
      return jar.stream()
          .map(entry -> entry.getName())
          .filter(name -> name.startsWith(FOLDER) && name.endsWith(SUFFIX))
          .map(name -> name.substring(FOLDER.length(), name.length() - SUFFIX.length()))
          .toList();
    }
    try (Stream<Path> files = Files.list(Path.of(URI.create(folder.toString())))) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(SUFFIX))
          .map(name -> name.substring(0, name.length() - SUFFIX.length()))
          .toList();
    }
  }

  private static RulePage read(String id, URL resource) {
    try (InputStream page = resource.openStream()) {
      String text = new String(page.readAllBytes(), StandardCharsets.UTF_8);
      return new RulePage(id, bundleOf(resource), text);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns the last segment of the bundle name in the manifest next to the page. */
  private static String bundleOf(URL resource) throws IOException {
    String address = resource.toString();
    String root = address.substring(0, address.lastIndexOf(FOLDER));
    URL manifest = URI.create(root + JarFile.MANIFEST_NAME).toURL();
    try (InputStream stream = manifest.openStream()) {
      String name = new Manifest(stream).getMainAttributes().getValue("Bundle-SymbolicName");
      return name == null ? "" : name.replaceFirst(";.*", "").replaceFirst(".*\\.", "");
    } catch (java.io.FileNotFoundException e) {
      return "";
    }
  }

  /**
   * Returns whether findings may be suppressed, for readers of files who know only ids. The page
   * tells users what {@link CommonTrait#UNSUPPRESSIBLE} tells the program.
   */
  public boolean mayBeSuppressed() {
    return !text.strip().endsWith(UNSUPPRESSIBLE);
  }

  /** Returns the first sentence, which explains the finding. */
  public String firstSentence() {
    String body =
        text.replaceFirst("\\A#[^\n]*\n+", "").replaceFirst("\\A\\*\\*What\\.\\*\\* ", "");
    String paragraph = body.split("\n\\s*\n", 2)[0].replaceAll("\\s+", " ").strip();
    return paragraph.replaceFirst("(?<=[.!?])\\s+(?=\\p{Lu}|`).*", "");
  }
}
