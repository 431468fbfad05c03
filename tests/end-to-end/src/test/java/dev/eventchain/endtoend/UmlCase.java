package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertTrue;

import dev.eventchain.fixtures.Projects;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * A model of UML, saved by Eclipse UML2, with its profile, a template and constraints.
 *
 * @param folder the folder of a copy, which a test may change
 */
record UmlCase(Path folder) {

  static final Path FILES = Program.ROOT.resolve("tests/end-to-end/src/test/resources/uml");

  static final String NAMESPACE = "http://www.eclipse.org/uml2/5.0.0/UML";

  /** Copies the files into a folder. */
  static UmlCase in(Path folder) throws IOException {
    return new UmlCase(Projects.copy(FILES, folder));
  }

  Path model() {
    return folder.resolve("shop.uml");
  }

  Path rules() {
    return folder.resolve("rules.ocl");
  }

  /** Returns the model with another text instead of one that it has, in a file of its own. */
  Path changed(String from, String to) throws IOException {
    String text = Files.readString(model());
    assertTrue(text.contains(from), from);
    return Files.writeString(folder.resolve("changed.uml"), text.replace(from, to));
  }

  Program.Ended validate(Path file) {
    return new Program().run("validate", "--ocl", rules(), file);
  }
}
