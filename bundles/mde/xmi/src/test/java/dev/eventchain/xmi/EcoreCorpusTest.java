package dev.eventchain.xmi;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.eclipse.emf.common.util.Diagnostic;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.EPackage;
import org.eclipse.emf.ecore.util.Diagnostician;
import org.eclipse.emf.ecore.util.EObjectValidator;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that metamodels with every construct of Ecore, and their models, are read without loss. */
class EcoreCorpusTest {

  private static final int CASES = 150;

  /** The ids of findings by EMF's codes. A value out of range is reported once per value here. */
  private static final Map<Integer, String> KINDS =
      Map.of(
          EObjectValidator.EOBJECT__EVERY_MULTIPCITY_CONFORMS, "multiplicity",
          EObjectValidator.EOBJECT__EVERY_DATA_VALUE_CONFORMS, "value",
          EObjectValidator.EOBJECT__EVERY_MAP_ENTRY_UNIQUE, "map",
          EObjectValidator.EOBJECT__EVERY_BIDIRECTIONAL_REFERENCE_IS_PAIRED, "opposite");

  @TempDir Path folder;

  @Test
  void everyMetamodelAndItsModelAreReadAndWrittenAsTheyAre() throws IOException {
    int faulty = 0;
    for (int seed = 0; seed < CASES; seed++) {
      Path home = Files.createDirectory(folder.resolve("case" + seed));
      EcoreCorpus corpus = new EcoreCorpus(seed);
      Path ecore = Files.write(home.resolve("corpus.ecore"), XmiStore.toBytes(corpus.metamodel()));
      XmiStore store = new XmiStore(home);
      EPackage read = store.loadMetamodel(ecore).get(0);
      byte[] written = XmiStore.toBytes(corpus.model(read));
      Path model = Files.write(home.resolve("model.xmi"), written);
      List<LoadedModel> loaded = store.loadAll(List.of(model));
      assertEquals(text(written), text(XmiStore.toBytes(loaded.get(0).roots())), "seed " + seed);
      Map<String, Integer> found = ours(loaded);
      EObject root = loaded.get(0).roots().get(0);
      assertEquals(emfs(root), found, "seed " + seed);
      EcoreChecks inMemory =
          EcoreChecks.of(root, loaded.get(0).origins()::locate, Duration.ofSeconds(30));
      assertEquals(
          EcoreChecks.of(loaded).diagnostics(), inMemory.diagnostics(), "in memory, seed " + seed);
      faulty += found.isEmpty() ? 0 : 1;
    }
    assertTrue(faulty > CASES / 4, faulty + " models have faults");
  }

  private static String text(byte[] bytes) {
    return new String(bytes, StandardCharsets.UTF_8);
  }

  private static Map<String, Integer> ours(List<LoadedModel> loaded) {
    Map<String, Integer> found = new TreeMap<>();
    for (var diagnostic : EcoreChecks.of(loaded).diagnostics()) {
      String kind = diagnostic.id().substring("ecore.".length());
      String known = kind.equals("required") || kind.equals("bound") ? "multiplicity" : kind;
      found.merge(known, 1, Integer::sum);
    }
    return found;
  }

  private static Map<String, Integer> emfs(EObject root) {
    Map<String, Integer> found = new TreeMap<>();
    for (Diagnostic child : new Diagnostician().validate(root).getChildren()) {
      int values = child.getChildren().isEmpty() ? 1 : child.getChildren().size();
      found.merge(KINDS.get(child.getCode()), values, Integer::sum);
    }
    return found;
  }
}
