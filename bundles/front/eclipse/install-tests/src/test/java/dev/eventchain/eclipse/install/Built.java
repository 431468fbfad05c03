package dev.eventchain.eclipse.install;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The build's artefacts, and the sources that define their expected contents. */
final class Built {

  private static final Path ECLIPSE = Path.of("").toAbsolutePath().getParent();

  static final Path FEATURE_XML = ECLIPSE.resolve("feature/feature.xml");
  static final Path LICENSE = ECLIPSE.resolve("../../../LICENSE");
  static final Path SITE = ECLIPSE.resolve("site/target/repository");
  static final Path WORKBENCH =
      ECLIPSE.resolve("product/target/products/dev.eventchain.workbench/linux/gtk/x86_64");

  /** Identifier by which p2 installs the feature. */
  static final String FEATURE = "dev.eventchain.feature.feature.group";

  private static final Pattern PLUGIN = Pattern.compile("<plugin id=\"([^\"]+)\"");
  private static final Pattern BUNDLE = Pattern.compile("<bundle id=\"([^\"]+)\"");

  private Built() {}

  /** Returns the symbolic names of our bundles. */
  static SortedSet<String> ours() throws IOException {
    return names(PLUGIN, Files.readString(FEATURE_XML));
  }

  /** Returns the symbolic names of the bundles of others that the update site brings along. */
  static SortedSet<String> theirs() throws IOException {
    return names(BUNDLE, Files.readString(ECLIPSE.resolve("site/category.xml")));
  }

  private static SortedSet<String> names(Pattern pattern, String text) {
    SortedSet<String> names = new TreeSet<>();
    Matcher matcher = pattern.matcher(text);
    while (matcher.find()) {
      names.add(matcher.group(1));
    }
    return names;
  }
}
