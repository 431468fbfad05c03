package dev.eventchain.endtoend;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code --root}: references may lead anywhere below a folder. */
class RootOptionTest {

  private static final String SPECIAL =
      """
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI" xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore" name="special" nsURI="http://example.org/special" nsPrefix="special">
        <eClassifiers xsi:type="ecore:EClass" name="Atlas" eSuperTypes="../low/library.ecore#//Book"/>
      </ecore:EPackage>
      """;

  @TempDir Path folder;
  private Path special;

  @BeforeEach
  void write() throws IOException {
    Path low = Files.createDirectories(folder.resolve("low"));
    Files.writeString(low.resolve("library.ecore"), AnyMetamodelTest.ECORE);
    Path high = Files.createDirectories(folder.resolve("high"));
    special = Files.writeString(high.resolve("special.ecore"), SPECIAL);
  }

  @Test
  void referenceToASiblingFolderNeedsTheirCommonRoot() {
    new Program().run("describe", special).expect(2).says("[xmi.href.refused]").says("--root DIR");
    new Program()
        .run("describe", "--root", folder, special)
        .expect(0)
        .says("class Atlas extends Book");
    new Program()
        .run("describe", "--root", folder.resolve("high"), special)
        .expect(2)
        .says("[xmi.href.refused]");
  }

  @Test
  void rootMustBeAFolder() {
    new Program().run("describe", "--root", special, special).expect(2).says("no such folder");
    new Program()
        .run("describe", "--root", folder.resolve("nowhere"), special)
        .expect(2)
        .says("no such folder");
  }
}
