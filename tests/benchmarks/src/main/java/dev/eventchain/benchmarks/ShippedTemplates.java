package dev.eventchain.benchmarks;

import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.TemplateModule;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/** The template sets of the repository; the working folder is its root, or two below it. */
final class ShippedTemplates {

  private static final Path FOLDER =
      Files.isDirectory(Path.of("templates")) ? Path.of("templates") : Path.of("../../templates");

  private ShippedTemplates() {}

  static TemplateModule compile(String set) {
    return TemplateModule.compile(
        SourceText.read(FOLDER.resolve(set).resolve("main.mtl")),
        name -> find(set, name),
        List.of(EventchainPackage.eINSTANCE));
  }

  /** In the set, else among what the sets in Python share. */
  private static Optional<SourceText> find(String set, String name) {
    String file = name.substring(name.lastIndexOf(':') + 1) + ".mtl";
    return Stream.of(set, "python")
        .map(folder -> FOLDER.resolve(folder).resolve(file))
        .filter(Files::exists)
        .findFirst()
        .map(SourceText::read);
  }
}
