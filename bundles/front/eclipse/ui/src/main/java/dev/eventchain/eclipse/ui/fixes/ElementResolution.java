package dev.eventchain.eclipse.ui.fixes;

import dev.eventchain.diagnostics.DiagnosticException;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.eclipse.FindingMarker;
import dev.eventchain.model.EventChainMetamodel;
import dev.eventchain.xmi.LoadedModel;
import dev.eventchain.xmi.XmiStore;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Optional;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.core.runtime.CoreException;
import org.eclipse.core.runtime.Status;
import org.eclipse.emf.ecore.EObject;
import org.eclipse.emf.ecore.util.EcoreUtil;
import org.eclipse.ui.IMarkerResolution;

/** Fixes a finding by a change of the model, which is saved as by the editor. */
record ElementResolution(ElementFix fix) implements IMarkerResolution {

  @Override
  public String getLabel() {
    return fix.label();
  }

  @Override
  public void run(IMarker marker) {
    IFile file = (IFile) marker.getResource();
    String element = marker.getAttribute(FindingMarker.ELEMENT, "");
    int line = marker.getAttribute(IMarker.LINE_NUMBER, 0);
    FileEdit.start(fix.label(), file, text -> changed(file, element, line));
  }

  private Optional<String> changed(IFile file, String path, int line) throws CoreException {
    try {
      Path location = file.getLocation().toPath();
      LoadedModel model = EventChainMetamodel.store(location.getParent()).load(location);
      Optional<EObject> element = find(model, path, line);
      return element.isPresent() && fix.apply(element.get(), file)
          ? Optional.of(new String(XmiStore.toBytes(model.roots()), StandardCharsets.UTF_8))
          : Optional.empty();
    } catch (DiagnosticException e) {
      throw new CoreException(Status.error(e.diagnostics().get(0).message()));
    }
  }

  /** Returns the element at a path; of several with the same name, the one at the line. */
  private static Optional<EObject> find(LoadedModel model, String path, int line) {
    EObject found = null;
    Iterator<EObject> all = EcoreUtil.getAllProperContents(model.roots(), false);
    while (all.hasNext()) {
      EObject each = all.next();
      SourceLocation place = model.origins().locate(each);
      if (place.element().equals(path) && (found == null || place.line() <= line)) {
        found = each;
      }
    }
    return Optional.ofNullable(found);
  }
}
