package dev.eventchain.endtoend;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code compile}, which checks templates without a model. */
class CompileTest {

  private static final String ECORE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
          xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore"
          name="shop" nsURI="http://shop/1.0" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Item">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="label"
              eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EString"/>
        </eClassifiers>
      </ecore:EPackage>
      """;

  @TempDir Path folder;

  private Path template(String name, String feature) throws IOException {
    return Files.writeString(
        folder.resolve(name),
        "[module %s('http://shop/1.0')]\n[template public t(i : Item)]\n[i.%s/]\n[/template]\n"
            .formatted(name.replace(".mtl", ""), feature));
  }

  @Test
  void allTemplatesOfAFolderAreCompiled() {
    new Program()
        .run("compile", Program.ROOT.resolve("templates"))
        .expect(0)
        .says("0 errors, 0 warnings in ");
  }

  @Test
  void eachTemplateIsCheckedAgainstTheMetamodel() throws IOException {
    Path ecore = Files.writeString(folder.resolve("shop.ecore"), ECORE);
    Path good = template("good.mtl", "label");
    new Program().run("compile", "--metamodel", ecore, good).expect(0).says("in 1 file");
    template("bad.mtl", "lable");
    template("worse.mtl", "price");
    new Program()
        .run("compile", "--metamodel", ecore, folder)
        .expect(1)
        .says("bad.mtl:3:4: error: Item has no feature 'lable'. [ocl.type]")
        .says("Did you mean `label`?")
        .says("worse.mtl:3:4: error: Item has no feature 'price'.")
        .says("2 errors, 0 warnings in 3 files");
  }

  @Test
  void aTemplateOfAProjectMayImportTheShippedOnes() throws IOException {
    Files.writeString(folder.resolve("eventchain.yaml"), "name: own\n");
    Path own = folder.resolve("mine.mtl");
    Files.writeString(
        own,
        """
        [module mine('http://eventchain.dev/eventchain/1.0')]
        [import ros2_python::main /]
        [template public mine(chain : EventChain)]
        [comment @main /]
        [chain.main()/]
        [/template]
        """);
    new Program().run("compile", own).expect(0).says("0 errors");
    Path missing = folder.resolve("missing.mtl");
    template("bad.mtl", "label");
    new Program()
        .run("compile", folder.resolve("bad.mtl"), missing)
        .expect(2)
        .says("m2t.metamodel")
        .says("missing.mtl: error: There is no such file.");
  }

  @Test
  void nothingToCompileIsNoSuccess() throws IOException {
    Path empty = Files.createDirectory(folder.resolve("empty"));
    new Program().run("compile", empty).expect(2).says("there is no template (*.mtl)");
    new Program().run("compile", folder.resolve("no.mtl")).expect(2).says("file.missing");
    new Program().run("compile", template("unknown.mtl", "label")).expect(1).says("m2t.metamodel");
    new Program().run("compile", empty, "-o", folder).expect(2).says("nothing is written");
  }
}
