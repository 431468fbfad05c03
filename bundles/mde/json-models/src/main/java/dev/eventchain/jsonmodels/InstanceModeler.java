package dev.eventchain.jsonmodels;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.documents.Document;
import dev.eventchain.xmi.Origins;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;

/**
 * Converts a conceptual instance model, JSON that language models write well (paper, Section IV-B;
 * arXiv 2503.22587), into a model of any Ecore metamodel.
 *
 * <p>An object names its class in {@code eClass} and itself in {@code id}; the other properties are
 * features. Contained objects are nested in their containment feature, or listed there by id; all
 * other references are ids. The document is one object, an array of objects, or an object with an
 * array for each class ({@code {"Book": [...], "Person": [...]}}). {@code null} means that a
 * feature is not set. If a class has an attribute {@code id}, the property sets it, too.
 */
public final class InstanceModeler {

  private final ClassIndex classes;

  /** Creates a modeler for the classes of some metamodels and their subpackages. */
  public InstanceModeler(Collection<? extends EPackage> metamodels) {
    classes = new ClassIndex(metamodels);
  }

  /**
   * Reads an instance model.
   *
   * @return the root objects in the order of the text, and all findings about the text
   * @throws dev.eventchain.diagnostics.DiagnosticException INPUT ({@code modeler.json.syntax}) if
   *     the text is not JSON
   */
  public Modeled<List<EObject>> model(SourceText instance) {
    Document text = JsonDocument.parse(instance);
    List<Diagnostic> findings = new ArrayList<>();
    Origins origins = new Origins();
    InstanceObjects objects = new InstanceObjects(text, classes, origins, findings);
    objects.read();
    new InstanceLinks(text, objects, findings).link();
    List<EObject> roots =
        objects.all().stream().filter(object -> object.eContainer() == null).toList();
    for (EObject object : objects.all()) {
      new MultiplicityCheck(objects, findings).check(object);
    }
    if (objects.all().isEmpty() && findings.isEmpty()) {
      findings.add(
          Diagnostic.of(
              InstanceRules.INSTANCE_EMPTY, "The document contains no object.", text.at("")));
    }
    return new Modeled<>(roots, origins, findings.stream().distinct().sorted().toList());
  }

  /**
   * Reads an instance model that consists of one object of a class and its contents.
   *
   * @return as {@link #model(SourceText)}; the root is an empty object of the class if there is
   *     none. Other root objects are findings.
   */
  public Modeled<EObject> modelOne(SourceText instance, EClass rootClass) {
    Modeled<List<EObject>> all = model(instance);
    List<Diagnostic> findings = new ArrayList<>(all.diagnostics());
    EObject root = null;
    for (EObject object : all.root()) {
      if (root == null && rootClass.isInstance(object)) {
        root = object;
      } else {
        String what =
            rootClass.isInstance(object)
                ? "There can be only one " + rootClass.getName() + "."
                : "Nothing contains this " + object.eClass().getName() + ".";
        findings.add(
            Diagnostic.of(InstanceRules.CONTAINMENT_MISSING, what, all.origins().locate(object))
                .withHint("Put it into a feature of the object that it belongs to."));
      }
    }
    if (root == null) {
      root = rootClass.getEPackage().getEFactoryInstance().create(rootClass);
      findings.add(
          Diagnostic.of(
              InstanceRules.INSTANCE_EMPTY,
              "There is no " + rootClass.getName() + " here.",
              instance.at(0)));
    }
    return new Modeled<>(root, all.origins(), findings.stream().sorted().toList());
  }
}
