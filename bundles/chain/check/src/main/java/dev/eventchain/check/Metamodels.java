package dev.eventchain.check;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.model.eventchain.EventchainPackage;
import dev.eventchain.xmi.XmiStore;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import org.eclipse.emf.ecore.EPackage;

/** Metamodels for the rules and templates that are edited together with them. */
public final class Metamodels {

  private Metamodels() {}

  /**
   * Returns the packages of the files, and those of event chains and of message definitions unless
   * a file has their namespace. Invalid metamodels are left out: they have their own findings.
   */
  public static List<EPackage> of(List<Path> ecores) {
    List<EPackage> packages = new ArrayList<>();
    load(ecores, (file, loaded) -> packages.addAll(loaded));
    for (EPackage ours : List.of(EventchainPackage.eINSTANCE, EventChainMetamodel.messages())) {
      if (packages.stream().noneMatch(each -> ours.getNsURI().equals(each.getNsURI()))) {
        packages.add(ours);
      }
    }
    return packages;
  }

  /** Returns the files with valid metamodels that do not contradict each other. */
  public static List<Path> sound(List<Path> ecores) {
    List<Path> sound = new ArrayList<>();
    load(ecores, (file, loaded) -> sound.add(file));
    return sound;
  }

  /**
   * Loads a metamodel after all others, so that conflicts are reported at each of them.
   *
   * @return the store that holds it
   * @throws DiagnosticException INPUT with its errors
   */
  static XmiStore loadLast(Path ecore, List<Path> all, List<EPackage> loaded) {
    List<Path> others = all.stream().filter(each -> !each.equals(ecore)).toList();
    XmiStore store = load(all, others, (file, packages) -> {});
    loaded.addAll(store.loadMetamodel(ecore));
    return store;
  }

  private static void load(List<Path> ecores, BiConsumer<Path, List<EPackage>> sound) {
    load(ecores, ecores, sound);
  }

  private static XmiStore load(
      List<Path> places, List<Path> ecores, BiConsumer<Path, List<EPackage>> sound) {
    List<Path> folders = places.stream().map(Path::getParent).distinct().toList();
    XmiStore store = EventChainMetamodel.store(folders);
    for (Path ecore : ecores) {
      try {
        sound.accept(ecore, store.loadMetamodel(ecore));
      } catch (DiagnosticException e) {
        // Its own check loads it separately and reports the reason.
      }
    }
    return store;
  }

  /** Returns the usual file name extensions of models of these metamodels in EMF. */
  public static Set<String> extensions(List<Path> ecores) {
    Set<String> extensions = new HashSet<>();
    load(
        ecores,
        (file, loaded) ->
            loaded.forEach(
                each -> {
                  extensions.add(each.getName());
                  extensions.add(String.valueOf(each.getNsPrefix()));
                }));
    return extensions;
  }
}
