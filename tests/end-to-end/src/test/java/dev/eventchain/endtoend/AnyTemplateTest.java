package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Tests a template with the structure of Acceleo projects: modules in packages, Java services,
 * properties.
 */
class AnyTemplateTest {

  private static final String METAMODEL = "('http://example.org/library')]\n";

  private static final String MAIN =
      """
      [import org::example::library::files::page]
      [template public main(library : Library)]
      [comment @main /]
      [for (book : Book | library.books)]
      [book.page()/]
      [/for]
      [/template]
      """;

  private static final String PAGE =
      """
      [import parts]
      [import org::common::names]
      [template public page(book : Book)]
      [file (book.fileName(), false, 'UTF-8')]
      [book.heading()/]
      [getProperty('publisher')/], [getProperty('year')/]
      [/file]
      [/template]
      """;

  private static final String PARTS =
      """
      [import org::example::library::services::words]
      [template public heading(book : Book)]
      [book.title.loud()/] ([book.pages/])
      [/template]
      """;

  private static final String WORDS =
      """
      [query public loud(text : String) : String =
        invoke('org.example.library.services.Words', 'loud(String)', Sequence{text}) /]
      """;

  private static final String NAMES =
      """
      [template public fileName(book : Book)][book.title.toLowerCase()/].txt[/template]
      """;

  private static final String SERVICE =
      """
      package org.example.library.services;
      public class Words {
        public String loud(String word) {
          return word.toUpperCase(java.util.Locale.ROOT) + "!";
        }
      }
      """;

  @TempDir Path folder;

  @BeforeEach
  void write() throws IOException {
    file("library.ecore", AnyMetamodelTest.ECORE);
    file("model.xmi", AnyMetamodelTest.MODEL);
    String own = "src/org/example/library/";
    file(own + "main/main.mtl", "[module main" + METAMODEL + MAIN);
    file(own + "files/page.mtl", "[module page" + METAMODEL + PAGE);
    file(own + "files/parts.mtl", "[module parts" + METAMODEL + PARTS);
    file(own + "services/words.mtl", "[module words" + METAMODEL + WORDS);
    file("common/src/org/common/names.mtl", "[module names" + METAMODEL + NAMES);
    file("first.properties", "publisher=Good Books\n");
    file("second.properties", "publisher=Nobody\nyear=1999\n");
    jar(file("Words.java", SERVICE));
  }

  private Path file(String name, String text) throws IOException {
    Path file = folder.resolve(name);
    Files.createDirectories(file.getParent());
    return Files.writeString(file, text);
  }

  private void jar(Path source) throws IOException {
    Path classes = folder.resolve("classes");
    int failed =
        ToolProvider.getSystemJavaCompiler()
            .run(null, null, null, "-proc:none", "-d", classes.toString(), source.toString());
    assertEquals(0, failed);
    String entry = "org/example/library/services/Words.class";
    try (OutputStream file = Files.newOutputStream(folder.resolve("services.jar"));
        JarOutputStream jar = new JarOutputStream(file)) {
      jar.putNextEntry(new JarEntry(entry));
      Files.copy(classes.resolve(entry), jar);
    }
  }

  private Program.Ended generate(Object... more) throws IOException {
    Object[] command = {
      "generate",
      "--metamodel",
      folder.resolve("library.ecore"),
      "--template",
      folder.resolve("src/org/example/library/main/main.mtl"),
      folder.resolve("model.xmi"),
      "-o",
      folder.resolve("out")
    };
    Object[] all = new Object[command.length + more.length];
    System.arraycopy(command, 0, all, 0, command.length);
    System.arraycopy(more, 0, all, command.length, more.length);
    return new Program().run(all);
  }

  @Test
  void aProjectWithSourceRootsServicesAndPropertiesIsGeneratedByOneCommand() throws IOException {
    generate(
            "--source",
            folder.resolve("common/src"),
            "--services",
            folder.resolve("services.jar"),
            "--properties",
            folder.resolve("first.properties"),
            "--properties",
            folder.resolve("second.properties"))
        .expect(0);
    assertEquals(
        "GOOD! (100)\nGood Books, 1999\n", Files.readString(folder.resolve("out/good.txt")));
    assertEquals("BAD! (-1)\nGood Books, 1999\n", Files.readString(folder.resolve("out/bad.txt")));
  }

  @Test
  void aModuleInAnotherSourceRootIsMissingUntilItIsNamed() throws IOException {
    generate()
        .expect(2)
        .says("[m2t.module.missing]")
        .says("There is no module 'org::common::names'.")
        .says("name the folder that has org/common/names.mtl: --source FOLDER");
  }
}
