package dev.eventchain.m2t;

import static java.nio.charset.StandardCharsets.UTF_8;

import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.m2t.generation.GenerationResult;
import java.util.List;
import java.util.Optional;
import org.eclipse.emf.ecore.EAttribute;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EcoreFactory;
import org.eclipse.emf.ecore.EcorePackage;

/** Generator for bodies of files and templates, which may use {@code l}, a library called City. */
final class WhiteSpaceBodies {
  private static final EPackage LIBRARY = library();
  private static final EObject CITY = city();

  private WhiteSpaceBodies() {}

  /** Returns the output of a {@code [file]} block with a body. */
  static String file(String body) {
    return file(body, "[template public t(l : Library)]");
  }

  /** Returns the output of a template with a body, called between {@code <} and {@code >}. */
  static String called(String body) {
    return file("<[l.t()/]>", "[template public t(l : Library)]" + body);
  }

  /** Returns the output of a file with an unclosed template that it calls. */
  static String file(String body, String template) {
    String module =
        "[module m('http://library')/]\n[template public main(l : Library)]\n[comment @main /]\n"
            + ("[file ('out.txt', false, 'UTF-8')]" + body + "[/file]\n[/template]\n")
            + (template + "[/template]\n[template public one(l : Library)]one[/template]\n");
    TemplateModule compiled =
        TemplateModule.compile(
            SourceText.of("m.mtl", module), name -> Optional.empty(), List.of(LIBRARY));
    GenerationResult result = compiled.generate(List.of(CITY), any -> SourceLocation.of("m.xmi"));
    return new String(result.files().get("out.txt"), UTF_8);
  }

  private static EPackage library() {
    EClass type = EcoreFactory.eINSTANCE.createEClass();
    type.setName("Library");
    EAttribute name = EcoreFactory.eINSTANCE.createEAttribute();
    name.setName("name");
    name.setEType(EcorePackage.Literals.ESTRING);
    type.getEStructuralFeatures().add(name);
    EPackage made = EcoreFactory.eINSTANCE.createEPackage();
    made.setName("library");
    made.setNsPrefix("library");
    made.setNsURI("http://library");
    made.getEClassifiers().add(type);
    return made;
  }

  private static EObject city() {
    EClass type = (EClass) LIBRARY.getEClassifiers().get(0);
    EObject city = LIBRARY.getEFactoryInstance().create(type);
    city.eSet(type.getEStructuralFeature("name"), "City");
    return city;
  }
}
