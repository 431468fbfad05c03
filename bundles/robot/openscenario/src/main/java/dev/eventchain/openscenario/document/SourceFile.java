package dev.eventchain.openscenario.document;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.XmlText;
import dev.eventchain.documents.XmlElement;
import dev.eventchain.openscenario.vocabulary.DataType;
import dev.eventchain.openscenario.vocabulary.Version;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The XML of a file, and the version that it declares. */
final class SourceFile {

  private static final long LARGEST = 32L << 20;

  private SourceFile() {}

  /** Returns the root, which is {@code OpenSCENARIO}. */
  static XmlElement read(Path file) {
    SourceLocation whole = SourceLocation.of(file);
    long size = sizeOf(file);
    if (size > LARGEST) {
      throw Findings.refused(
          DocumentRules.SIZE,
          "The file has " + size + " bytes; at most " + LARGEST + " are read.",
          whole,
          "Divide it, with catalogs for what is repeated.");
    }
    XmlElement root = XmlElement.parse(XmlText.read(file, whole.file()), DocumentRules.SYNTAX);
    if (!root.name().equals("OpenSCENARIO")) {
      throw Findings.refused(
          DocumentRules.SYNTAX,
          "The root is `" + root.name() + "`, not `OpenSCENARIO`.",
          root.location(),
          "Name a file in OpenSCENARIO XML.");
    }
    return root;
  }

  /** Returns the size of a regular file; 0 for what reading it will report. */
  private static long sizeOf(Path file) {
    try {
      return Files.isRegularFile(file) ? Files.size(file) : 0;
    } catch (IOException e) {
      return 0;
    }
  }

  static Version version(XmlElement root) {
    Optional<XmlElement> header = root.child("FileHeader");
    if (header.isEmpty()) {
      throw Findings.refused(
          DocumentRules.VERSION,
          "The file declares no version: it has no `FileHeader`.",
          root.location(),
          "Add a `FileHeader` with `revMajor` and `revMinor`.");
    }
    String major = header.get().attribute("revMajor").orElse("").strip();
    String minor = header.get().attribute("revMinor").orElse("").strip();
    boolean whole = DataType.UNSIGNED_SHORT.canonical(minor).isPresent();
    if (!major.equals("1") || !whole || Integer.parseInt(minor) > Version.LATEST.minor()) {
      throw Findings.refused(
          DocumentRules.VERSION,
          "The file declares version `" + major + "." + minor + "`.",
          header.get().location("revMajor"),
          "Versions 1.0 to 1.3 are read.");
    }
    return new Version(Integer.parseInt(minor));
  }
}
