package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests diagrams of the example, of other models, and of invalid models. */
class DiagramTest {

  private static final Path METAMODEL = Program.ROOT.resolve("metamodel/eventchain.ecore");

  @TempDir Path folder;

  /** Another process, another folder: the same bytes as in the README. */
  @Test
  void exampleIsDrawnAsTheReadmeShowsIt() throws IOException {
    Path project = Program.exampleIn(folder);

    new Program().run("diagram", project).expect(0);

    Path drawn = project.resolve("out/diagrams");
    assertArrayEquals(
        Files.readAllBytes(Program.ROOT.resolve("examples/aeb/event-chain.svg")),
        Files.readAllBytes(drawn.resolve("activity.svg")));
    for (String kind : new String[] {"activity", "instance", "metamodel"}) {
      FileTime past = FileTime.fromMillis(1_000_000_000);
      Files.setLastModifiedTime(drawn.resolve(kind + ".puml"), past);
      Files.setLastModifiedTime(drawn.resolve(kind + ".svg"), past);
    }
    new Program().run("diagram", project).expect(0);
    for (String kind : new String[] {"activity", "instance", "metamodel"}) {
      assertEquals(
          1_000_000_000, Files.getLastModifiedTime(drawn.resolve(kind + ".svg")).toMillis());
      assertEquals(
          1_000_000_000, Files.getLastModifiedTime(drawn.resolve(kind + ".puml")).toMillis());
    }
  }

  @Test
  void modelOfAnyMetamodelIsDrawn() throws IOException {
    Path ecore = Program.ROOT.resolve("metamodel/messages.ecore");
    Path model =
        Files.writeString(
            folder.resolve("model.xmi"),
            """
            <?xml version="1.0" encoding="UTF-8"?>
            <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="shapes"/>
            """);

    Path out = folder.resolve("out");
    new Program().run("diagram", "--metamodel", ecore, model, "-o", out).expect(0);
    new Program().run("diagram", METAMODEL, "-o", out).expect(0);

    assertTrue(
        Files.readString(out.resolve("instance.svg")).contains("shapes\u00a0:\u00a0EPackage"));
    assertTrue(Files.readString(out.resolve("metamodel.svg")).contains("SoftwareNode"));
    assertFalse(Files.exists(out.resolve("activity.svg")));
  }

  @Test
  void whatCannotBeDrawnIsSaid() {
    Path out = folder.resolve("out");
    new Program()
        .run("diagram", METAMODEL, "--kind", "activity", "-o", out)
        .expect(1)
        .says("diagram.nothing");
    new Program()
        .run("diagram", METAMODEL, "--kind", "sequence", "-o", out)
        .expect(2)
        .says("--kind");
    new Program()
        .run("diagram", folder.resolve("no.xmi"), "-o", out)
        .expect(2)
        .says("file.missing");
    new Program().run("diagram", folder.resolve("nowhere")).expect(2).says("project.missing");
    new Program().run("diagram", METAMODEL).expect(2).says("-o FOLDER");
  }
}
