package dev.eventchain.eclipse.ui.fixes;

import dev.eventchain.diagnostics.TextFix;
import dev.eventchain.eclipse.FindingMarker;
import java.util.ArrayList;
import java.util.List;
import org.eclipse.core.resources.IFile;
import org.eclipse.core.resources.IMarker;
import org.eclipse.ui.IMarkerResolution;
import org.eclipse.ui.IMarkerResolutionGenerator2;

/** The quick fixes of our markers, and the explanation of each. */
public final class Resolutions implements IMarkerResolutionGenerator2 {

  @Override
  public boolean hasResolutions(IMarker marker) {
    return !marker.getAttribute(FindingMarker.ID, "").isEmpty();
  }

  @Override
  public IMarkerResolution[] getResolutions(IMarker marker) {
    List<IMarkerResolution> found = new ArrayList<>();
    String id = marker.getAttribute(FindingMarker.ID, "");
    if (marker.getResource() instanceof IFile) {
      String hint = marker.getAttribute(FindingMarker.HINT, "");
      TextFix.meant(hint).ifPresent(name -> found.add(TextResolution.nearestName(name)));
      switch (id) {
        case "xmi.reference.unresolved" -> found.add(TextResolution.withoutReference());
        case "contract.unit.mismatch" -> found.add(new ElementResolution(ElementFix.UNIT));
        case "contract.qos.incompatible", "contract.qos.ambiguous", "contract.qos.undecided" ->
            found.add(new ElementResolution(ElementFix.QUALITY_OF_SERVICE));
        case "project.requirement.changed" ->
            found.add(new ElementResolution(ElementFix.REQUIREMENT_TEXT));
        default -> {
          // The remaining findings need people.
        }
      }
    }
    found.add(new ExplainResolution(id));
    return found.toArray(IMarkerResolution[]::new);
  }
}
