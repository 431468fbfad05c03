package dev.eventchain.eclipse;

import dev.eventchain.check.ChainChecks;
import dev.eventchain.check.FileChecks;
import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.model.eventchain.EventChain;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.ResourcesPlugin;
import org.eclipse.core.runtime.IPath;
import org.eclipse.emf.common.util.BasicDiagnostic;
import org.eclipse.emf.common.util.DiagnosticChain;
import org.eclipse.emf.common.util.URI;
import org.eclipse.emf.ecore.EClass;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EObjectValidator;
import org.eclipse.emf.ecore.util.EcoreUtil;

/**
 * Validator for EMF's validation, so that Validate in any EMF editor finds what the builder finds.
 * It applies the rules of the model's project, or the standard ones. Violations of the metamodel
 * itself may be reported twice, by EMF and by this validator.
 */
public final class ChainValidator extends EObjectValidator {

  /** Key under which a validation records that the chain was checked. */
  private static final Object DONE = ChainValidator.class;

  @Override
  public boolean validate(
      EClass type, EObject element, DiagnosticChain diagnostics, Map<Object, Object> context) {
    boolean good = super.validate(type, element, diagnostics, context);
    if (diagnostics == null || context == null || context.put(DONE, element) != null) {
      return good; // part of a validation that has already checked its first element
    }
    return EcoreUtil.getRootContainer(element) instanceof EventChain chain
        ? check(chain, element, diagnostics) && good
        : good;
  }

  /** Checks the whole chain, and reports the findings about the element and its contents. */
  private static boolean check(EventChain chain, EObject element, DiagnosticChain diagnostics) {
    ChainFindings findings;
    try {
      findings = ChainFindings.of(chain, checks(chain.eResource()));
    } catch (DiagnosticException e) {
      e.diagnostics().forEach(each -> diagnostics.add(diagnostic(each, element)));
      return false;
    } catch (RuntimeException | StackOverflowError e) {
      diagnostics.add(diagnostic(FileChecks.failed(e), element));
      return false;
    }
    boolean good = true;
    for (ChainFindings.Found each : findings.found()) {
      EObject about = each.element().orElse(chain);
      if (EcoreUtil.isAncestor(element, about)) {
        BasicDiagnostic diagnostic = diagnostic(each.diagnostic(), about);
        diagnostics.add(diagnostic);
        good &= diagnostic.getSeverity() < BasicDiagnostic.ERROR;
      }
    }
    return good;
  }

  private static BasicDiagnostic diagnostic(Diagnostic finding, EObject about) {
    int severity =
        switch (finding.severity()) {
          case ERROR -> BasicDiagnostic.ERROR;
          case WARNING -> BasicDiagnostic.WARNING;
          case INFO -> BasicDiagnostic.INFO;
        };
    String hint = finding.hint().isEmpty() ? "" : " " + finding.hint();
    return new BasicDiagnostic(
        severity, EventchainCore.ID, 0, finding.message() + hint, new Object[] {about});
  }

  private static ChainChecks checks(Resource resource) {
    return fileOf(resource)
        .map(EventchainFolders::checksFor)
        .orElseGet(() -> ChainChecks.alone(Preferences.timeLimit()));
  }

  private static Optional<IFile> fileOf(Resource resource) {
    URI uri = resource == null ? null : resource.getURI();
    if (uri == null) {
      return Optional.empty();
    } else if (uri.isPlatformResource()) {
      IPath path = IPath.fromPortableString(uri.toPlatformString(true));
      return path.segmentCount() < 2
          ? Optional.empty()
          : Optional.of(ResourcesPlugin.getWorkspace().getRoot().getFile(path));
    } else if (uri.isFile()) {
      java.net.URI location = Path.of(uri.toFileString()).toUri();
      return List.of(ResourcesPlugin.getWorkspace().getRoot().findFilesForLocationURI(location))
          .stream()
          .findFirst();
    }
    return Optional.empty();
  }
}
