package dev.eventchain.jsonmodels;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import com.networknt.schema.JsonSchema;
import com.networknt.schema.JsonSchemaFactory;
import com.networknt.schema.SpecVersion;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceText;
import dev.eventchain.fixtures.ExpectedFile;
import dev.eventchain.fixtures.RandomJson;
import dev.eventchain.xmi.XmiStore;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.IntStream;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.EReference;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

class MetamodelSchemaTest {

  private static final int INSTANCES = 60;

  /** The ids of findings that a schema can prevent. */
  private static final Set<String> STRUCTURAL =
      Set.of(
          "modeler.class.abstract",
          "modeler.class.ambiguous",
          "modeler.class.missing",
          "modeler.class.unknown",
          "modeler.enum.unknown",
          "modeler.feature.derived",
          "modeler.feature.missing",
          "modeler.feature.unknown",
          "modeler.value.type");

  private static final List<String> REFUSED_BY_PROVIDERS =
      List.of("oneOf", "allOf", "not", "minItems", "maxItems", "minimum", "maximum", "pattern");

  /** Metamodels with the classes of their roots. */
  enum Metamodel {
    LIBRARY("Library"),
    ZOO("Zoo"),
    EVENTCHAIN("EventChain");

    private final String root;

    Metamodel(String root) {
      this.root = root;
    }

    EPackage load() {
      Path folder = Path.of("src/test/resources/cases");
      return this == EVENTCHAIN
          ? TestMetamodels.eventChain()
          : new XmiStore(folder)
              .loadMetamodel(folder.resolve(name().toLowerCase(Locale.ROOT) + ".ecore"))
              .get(0);
    }

    MetamodelSchema schema(EPackage loaded) {
      return MetamodelSchema.of(List.of(loaded), (EClass) loaded.getEClassifier(root));
    }
  }

  @ParameterizedTest
  @EnumSource(names = {"LIBRARY", "ZOO"})
  void bothShapesAreAsExpected(Metamodel metamodel) throws IOException {
    MetamodelSchema schema = metamodel.schema(metamodel.load());
    String name = metamodel.name().toLowerCase(Locale.ROOT);
    Path folder = Path.of("src/test/resources");
    ExpectedFile.check(folder.resolve(name + ".schema.json"), text(schema.nested()));
    ExpectedFile.check(folder.resolve(name + ".flat.schema.json"), text(schema.flat()));
  }

  private static String text(JsonNode schema) {
    return schema.toPrettyString().replace("\r\n", "\n") + "\n";
  }

  @ParameterizedTest
  @EnumSource
  void schemasKeepToWhatStrictModesAccept(Metamodel metamodel) {
    MetamodelSchema schema = metamodel.schema(metamodel.load());
    checkStrict(schema.nested(), true);
    checkStrict(schema.flat(), false);
    assertEquals(List.of(), schema.flat().findValues("$ref"));
    assertEquals(List.of(), schema.flat().findValues("anyOf"));
  }

  @ParameterizedTest
  @EnumSource
  void everyPointerLeadsToADefinition(Metamodel metamodel) {
    ObjectNode schema = metamodel.schema(metamodel.load()).nested();
    List<JsonNode> pointers = schema.findValues("$ref");
    assertFalse(pointers.isEmpty());
    for (JsonNode pointer : pointers) {
      assertTrue(schema.at(pointer.asText().substring(1)).isObject(), pointer.asText());
    }
  }

  @ParameterizedTest
  @EnumSource
  void whateverASchemaAllowsIsRead(Metamodel metamodel) {
    EPackage loaded = metamodel.load();
    MetamodelSchema schema = metamodel.schema(loaded);
    for (ObjectNode shape : List.of(schema.nested(), schema.flat())) {
      JsonSchema validator = validator(shape);
      for (int seed = 0; seed < INSTANCES; seed++) {
        JsonNode instance = new RandomJson(shape, seed).next();
        assertEquals(Set.of(), validator.validate(instance), instance::toPrettyString);
        List<Diagnostic> findings =
            read(loaded, instance).diagnostics().stream()
                .filter(finding -> STRUCTURAL.contains(finding.id()))
                .toList();
        assertEquals(List.of(), findings, instance::toPrettyString);
      }
    }
  }

  @ParameterizedTest
  @EnumSource
  void aModelIsTheSameInBothShapes(Metamodel metamodel) {
    EPackage loaded = metamodel.load();
    ObjectNode nested = metamodel.schema(loaded).nested();
    ObjectNode flat = metamodel.schema(loaded).flat();
    JsonSchema nestedValidator = validator(nested);
    JsonSchema flatValidator = validator(flat);
    int objects = 0;
    for (int seed = 0; seed < INSTANCES; seed++) {
      JsonNode instance = new RandomJson(nested, seed).next();
      EObject model = read(loaded, instance).root().get(0);
      // Models that lack required targets cannot be written, nor those with contradictory
      // opposites.
      if (isComplete(model) && isMutual(model)) {
        checkWritten(loaded, model, nested, nestedValidator);
        // A plaque has no id, so it cannot be contained by id.
        Optional.ofNullable(model.eClass().getEStructuralFeature("plaque"))
            .ifPresent(model::eUnset);
        checkWritten(loaded, model, flat, flatValidator);
        objects += count(model);
      }
    }
    assertTrue(objects > INSTANCES, "objects: " + objects);
  }

  private static void checkWritten(
      EPackage metamodel, EObject model, ObjectNode schema, JsonSchema validator) {
    JsonNode written = InstanceJson.of(model, schema);
    assertEquals(Set.of(), validator.validate(written), written::toPrettyString);
    Modeled<List<EObject>> again = read(metamodel, written);
    assertEquals(
        List.of(),
        again.diagnostics().stream()
            .filter(finding -> !finding.id().equals("modeler.multiplicity"))
            .toList(),
        written::toPrettyString);
    assertEquals(1, again.root().size());
    assertTrue(new Equality().equals(model, again.root().get(0)), written::toPrettyString);
  }

  private static boolean isComplete(EObject object) {
    return object.eClass().getEAllReferences().stream()
            .allMatch(each -> each.isMany() || !each.isRequired() || object.eIsSet(each))
        && object.eContents().stream().allMatch(MetamodelSchemaTest::isComplete);
  }

  private static boolean isMutual(EObject object) {
    return object.eClass().getEAllReferences().stream()
            .filter(each -> each.getEOpposite() != null)
            .allMatch(
                each ->
                    ModelMatch.values(object, each).stream()
                        .map(target -> ModelMatch.values(target, each.getEOpposite()))
                        .allMatch(back -> Collections.frequency(back, object) == 1))
        && object.eContents().stream().allMatch(MetamodelSchemaTest::isMutual);
  }

  private static int count(EObject model) {
    int[] count = {0};
    model.eAllContents().forEachRemaining(each -> count[0]++);
    return count[0];
  }

  /** Equality that ignores the values of opposite lists, whose order follows from the text. */
  private static final class Equality extends EcoreUtil.EqualityHelper {
    private static final long serialVersionUID = 1L;

    @Override
    protected boolean haveEqualReference(EObject one, EObject other, EReference reference) {
      if (reference.getEOpposite() == null || reference.isContainment() || !reference.isMany()) {
        return super.haveEqualReference(one, other, reference);
      }
      return ((List<?>) one.eGet(reference)).size() == ((List<?>) other.eGet(reference)).size();
    }
  }

  @Test
  void idsThatExistAreAnEnumerationUnlessTheyAreTooMany() {
    EPackage loaded = Metamodel.LIBRARY.load();
    EClass section = (EClass) loaded.getEClassifier("Section");
    for (int count : List.of(1, 150, 400)) {
      List<String> ids = IntStream.range(0, count).mapToObj(i -> "S" + i).toList();
      ObjectNode flat = Metamodel.LIBRARY.schema(loaded).knowing(section, ids).flat();
      int values =
          flat.findValues("enum").stream().filter(JsonNode::isArray).mapToInt(JsonNode::size).sum();
      assertTrue(values <= EnumLimits.VALUES, () -> "values: " + values);
      boolean there = flat.at("/properties/Section/items/properties/id").has("enum");
      assertEquals(count <= 150, there);
    }
  }

  @Test
  void idsThatCannotBeThoseOfObjectsStayFree() {
    EPackage loaded = Metamodel.LIBRARY.load();
    EClass section = (EClass) loaded.getEClassifier("Section");
    for (List<String> ids : List.of(List.<String>of(), List.of("a", "a"), List.of("a", " "))) {
      ObjectNode flat = Metamodel.LIBRARY.schema(loaded).knowing(section, ids).flat();
      assertFalse(flat.at("/properties/Section/items/properties/id").has("enum"), ids::toString);
    }
  }

  private static JsonSchema validator(JsonNode schema) {
    return JsonSchemaFactory.getInstance(SpecVersion.VersionFlag.V202012).getSchema(schema);
  }

  private static Modeled<List<EObject>> read(EPackage metamodel, JsonNode instance) {
    return new InstanceModeler(List.of(metamodel))
        .model(SourceText.of("instance.json", instance.toPrettyString()));
  }

  private static void checkStrict(JsonNode schema, boolean allRequired) {
    if ("object".equals(schema.path("type").asText())) {
      Set<String> names = new LinkedHashSet<>();
      schema.get("properties").fieldNames().forEachRemaining(names::add);
      List<String> required = new ArrayList<>();
      schema.get("required").forEach(name -> required.add(name.asText()));
      assertTrue(names.containsAll(required));
      assertTrue(!allRequired || names.size() == required.size(), required::toString);
      assertFalse(schema.get("additionalProperties").asBoolean(true));
    }
    REFUSED_BY_PROVIDERS.forEach(keyword -> assertFalse(schema.has(keyword), keyword));
    schema
        .properties()
        .forEach(
            entry -> {
              boolean namesAreFree = Set.of("properties", "$defs").contains(entry.getKey());
              if (namesAreFree) {
                entry.getValue().forEach(each -> checkStrict(each, allRequired));
              } else {
                checkStrict(entry.getValue(), allRequired);
              }
            });
    if (schema.isArray()) {
      schema.forEach(each -> checkStrict(each, allRequired));
    }
  }
}
