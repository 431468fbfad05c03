package dev.eventchain.eclipse.ui.editor;

import dev.eventchain.analysis.ChainAnalysis;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.messages.MessageCatalog;
import dev.eventchain.metamodel.EcoreChecks;
import dev.eventchain.metamodel.LoadedModel;
import dev.eventchain.metamodel.XmiStore;
import dev.eventchain.metamodel.eventchain.EventChain;
import dev.eventchain.metamodel.eventchain.EventchainPackage;
import dev.eventchain.ocl.OclRules;
import dev.eventchain.ocl.OclValidator;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.runtime.IProgressMonitor;
import org.eclipse.emf.ecore.EObject;

/** What holds for any chain: the standard constraints, the metamodel and the message contracts. */
final class StandardValidation implements ChainValidation {

  private final Supplier<Optional<MessageCatalog>> messages;

  /** Parsed once, when the first chain is checked. */
  private static final class Standard {
    private static final OclRules RULES =
        OclRules.parse(
            List.of(XmiStore.standardConstraints()), List.of(EventchainPackage.eINSTANCE));
  }

  /**
   * @param messages the message types of the project
   */
  StandardValidation(Supplier<Optional<MessageCatalog>> messages) {
    this.messages = messages;
  }

  @Override
  public List<ElementFinding> validate(EventChain copy, IFile file, IProgressMonitor monitor) {
    ElementKeys keys = new ElementKeys(copy);
    List<Diagnostic> found = new ArrayList<>(ecore(copy));
    found.addAll(
        OclValidator.of(Standard.RULES).validate(List.of(copy), keys::locate).diagnostics());
    messages
        .get()
        .map(catalog -> ChainAnalysis.of(catalog, Optional.empty()))
        .ifPresent(analysis -> found.addAll(analysis.check(copy, keys::locate).diagnostics()));
    return found.stream().map(keys::about).toList();
  }

  /** Checks what would be read if the chain were saved now. */
  private static List<Diagnostic> ecore(EventChain chain) {
    Path file = null;
    try {
      file = Files.createTempFile("eventchain", ".xmi");
      Files.write(file, XmiStore.toBytes(chain));
      LoadedModel model = new XmiStore(file.getParent()).loadAll(List.of(file)).get(0);
      EObject root = model.roots().get(0);
      ElementKeys keys = new ElementKeys(root);
      keys.elements().forEach(each -> model.origins().put(each, keys.locate(each)));
      return EcoreChecks.of(List.of(model)).diagnostics();
    } catch (DiagnosticException e) { // such as characters that XML cannot hold
      return e.diagnostics();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } finally {
      delete(file);
    }
  }

  private static void delete(Path file) {
    try {
      if (file != null) {
        Files.deleteIfExists(file);
      }
    } catch (IOException e) { // the system clears its folder for such files
      file.toFile().deleteOnExit();
    }
  }
}
