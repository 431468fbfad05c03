package dev.eventchain.architecture;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Exports of the bundles, from their bnd instructions. */
final class Manifests {

  private static final Pattern EXPORTS = Pattern.compile("(?m)^Export-Package:((?:.*\\\\\\n)*.*)$");
  private static final Pattern PACKAGE = Pattern.compile("dev\\.eventchain(?:\\.\\w+)+");

  private Manifests() {}

  /** Returns the packages of all bundles, without those that EMF generates. */
  static Set<String> exportedPackages() throws IOException {
    Set<String> exported = new TreeSet<>();
    for (Path folder : BundleFolders.all()) {
      Path instructions = folder.resolve("bnd.bnd");
      if (Files.exists(instructions)) {
        Matcher exports = EXPORTS.matcher(Files.readString(instructions));
        while (exports.find()) {
          PACKAGE
              .matcher(exports.group(1))
              .results()
              .map(each -> each.group())
              .forEach(exported::add);
        }
      }
    }
    return exported;
  }
}
