package dev.eventchain.endtoend;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code describe}, which lists what a metamodel has. */
class DescribeTest {

  private static final String ECORE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <ecore:EPackage xmi:version="2.0" xmlns:xmi="http://www.omg.org/XMI"
          xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" xmlns:ecore="http://www.eclipse.org/emf/2002/Ecore"
          name="shop" nsURI="http://shop/1.0" nsPrefix="shop">
        <eClassifiers xsi:type="ecore:EClass" name="Thing" abstract="true"/>
        <eClassifiers xsi:type="ecore:EClass" name="Item" eSuperTypes="#//Thing">
          <eStructuralFeatures xsi:type="ecore:EAttribute" name="price" lowerBound="1" defaultValueLiteral="1.5"
              eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EDouble"/>
          <eStructuralFeatures xsi:type="ecore:EReference" name="parts" upperBound="-1" containment="true"
              eType="#//Item" eOpposite="#//Item/whole"/>
          <eStructuralFeatures xsi:type="ecore:EReference" name="whole" eType="#//Item" eOpposite="#//Item/parts"/>
          <eOperations name="costs" eType="ecore:EDataType http://www.eclipse.org/emf/2002/Ecore#//EInt">
            <eParameters name="kind" lowerBound="1" eType="#//kinds/Kind"/>
          </eOperations>
        </eClassifiers>
        <eSubpackages name="kinds" nsURI="http://shop/kinds" nsPrefix="k">
          <eClassifiers xsi:type="ecore:EEnum" name="Kind">
            <eLiterals name="NEW"/>
            <eLiterals name="OLD" value="5"/>
          </eClassifiers>
        </eSubpackages>
      </ecore:EPackage>
      """;

  private static final String LISTING =
      """
      package shop 'http://shop/1.0'
        abstract class Thing
        class Item extends Thing
          price : EDouble [1], default 1.5
          parts : Item [0..*], contained, opposite of whole
          whole : Item [0..1], opposite of parts
          costs(kind : Kind [1]) : EInt [0..1]
      package shop::kinds 'http://shop/kinds'
        enum Kind: NEW = 0, OLD = 5
      """;

  @TempDir Path folder;

  @Test
  void aMetamodelIsListedInTheOrderOfItsFile() throws IOException {
    Path ecore = Files.writeString(folder.resolve("shop.ecore"), ECORE);
    assertEquals(LISTING, new Program().run("describe", ecore).expect(0).out());
  }

  @Test
  void withoutAFileItIsThatOfEventChains() {
    String out = new Program().run("describe").expect(0).out();
    assertTrue(out.startsWith("package eventchain 'http"), out);
    assertTrue(out.contains("\n  class EventChain"), out);
  }

  @Test
  void aFileThatIsNoMetamodelIsFound() throws IOException {
    Path broken = Files.writeString(folder.resolve("broken.ecore"), "<a/>");
    new Program().run("describe", broken).expect(2).says("broken.ecore");
    new Program().run("describe", folder.resolve("none.ecore")).expect(2).says("none.ecore");
  }
}
