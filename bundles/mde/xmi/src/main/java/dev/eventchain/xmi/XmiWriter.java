package dev.eventchain.xmi;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.List;
import java.util.Map;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.resource.Resource;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.emf.ecore.xmi.XMIResource;
import org.eclipse.emf.ecore.xmi.XMLResource;
import org.eclipse.emf.ecore.xmi.impl.XMIResourceImpl;

/** Writes models as XMI with the same bytes on every machine. */
final class XmiWriter {

  private static final Map<String, Object> OPTIONS =
      Map.of(
          XMLResource.OPTION_ENCODING, "UTF-8",
          Resource.OPTION_LINE_DELIMITER, "\n",
          XMLResource.OPTION_PROCESS_DANGLING_HREF, XMLResource.OPTION_PROCESS_DANGLING_HREF_THROW);

  private XmiWriter() {}

  static byte[] write(List<? extends EObject> roots) {
    Resource home = roots.get(0).eResource();
    if (home instanceof XMIResource file && file.getContents().equals(roots)) {
      return save(file);
    }
    if (roots.stream().allMatch(root -> root.eResource() == null && root.eContainer() == null)) {
      XMIResource lent = new XMIResourceImpl();
      lent.getContents().addAll(roots);
      try {
        return save(lent);
      } finally {
        lent.getContents().clear();
      }
    }
    return save(copy(roots, home));
  }

  /** Copies roots, so that those that share a file with others are written on their own. */
  private static XMIResource copy(List<? extends EObject> roots, Resource home) {
    XMIResource copies = new XMIResourceImpl(home == null ? null : home.getURI());
    EcoreUtil.Copier copier = new EcoreUtil.Copier();
    copies.getContents().addAll(copier.copyAll(roots));
    copier.copyReferences();
    if (home instanceof XMIResource identified) {
      copier.forEach((original, copy) -> copies.setID(copy, identified.getID(original)));
    }
    return copies;
  }

  private static byte[] save(XMIResource resource) {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try {
      resource.save(bytes, OPTIONS);
    } catch (IOException | RuntimeException e) {
      Throwable cause = e.getCause() == null ? e : e.getCause();
      throw new DiagnosticException(
          DiagnosticException.Reason.FINDINGS,
          Diagnostic.of(
                  XmiRules.UNWRITABLE,
                  "The model cannot be written as XMI: " + cause.getMessage(),
                  SourceLocation.NONE.withElement(ModelPath.of(resource.getContents().get(0))))
              .withHint(
                  "Remove control characters from its strings, and references to elements that"
                      + " belong to no model."));
    }
    return bytes.toByteArray();
  }
}
