package dev.eventchain.eclipse.ui.fixes;

import dev.eventchain.eclipse.FindingMarker;
import dev.eventchain.eclipse.RulePages;
import org.eclipse.core.resources.IMarker;
import org.eclipse.jface.dialogs.Dialog;
import org.eclipse.jface.dialogs.IDialogConstants;
import org.eclipse.jface.resource.JFaceResources;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Shell;
import org.eclipse.swt.widgets.Text;
import org.eclipse.ui.IMarkerResolution;
import org.eclipse.ui.IMarkerResolutionRelevance;
import org.eclipse.ui.PlatformUI;

/**
 * Shows the page about a finding.
 *
 * @param id the identifier of the finding
 */
record ExplainResolution(String id) implements IMarkerResolution, IMarkerResolutionRelevance {

  private static final int WIDTH = 720;
  private static final int HEIGHT = 520;

  @Override
  public String getLabel() {
    return "Explain " + id;
  }

  /** Sorts the explanation after all fixes. */
  @Override
  public int getRelevanceForResolution() {
    return -1;
  }

  @Override
  public void run(IMarker marker) {
    String related = marker.getAttribute(FindingMarker.RELATED, "");
    String page = RulePages.of(id).orElse("There is no page about " + id + ".\n");
    String rule = marker.getAttribute(FindingMarker.RULE, "");
    String about = rule.isEmpty() ? "" : "Rule: " + rule + "\n";
    String see = related.isEmpty() ? "" : "See: " + related.replace("\n", ", ") + "\n";
    String before = about + see;
    page = paragraphs(page);
    new PageDialog(id, before.isEmpty() ? page : before + "\n" + page).open();
  }

  /** Joins the lines of each paragraph, since the dialog wraps them at its own width. */
  static String paragraphs(String markdown) {
    StringBuilder text = new StringBuilder();
    boolean code = false;
    boolean open = false;
    for (String line : markdown.lines().toList()) {
      boolean fence = line.startsWith("```");
      boolean plain = !code && !fence && !line.isBlank() && !line.matches("[\\s#|*-].*");
      text.append(text.isEmpty() ? "" : open && plain ? " " : "\n").append(line);
      code ^= fence;
      open = !code && !fence && !line.isBlank() && !line.startsWith("#");
    }
    return text.append('\n').toString();
  }

  private static final class PageDialog extends Dialog {
    private final String title;
    private final String page;

    PageDialog(String title, String page) {
      super(PlatformUI.getWorkbench().getModalDialogShellProvider());
      this.title = title;
      this.page = page;
    }

    @Override
    protected void configureShell(Shell shell) {
      super.configureShell(shell);
      shell.setText(title);
    }

    @Override
    protected boolean isResizable() {
      return true;
    }

    @Override
    protected Point getInitialSize() {
      return new Point(WIDTH, HEIGHT);
    }

    @Override
    protected Control createDialogArea(Composite parent) {
      Composite area = (Composite) super.createDialogArea(parent);
      Text text = new Text(area, SWT.MULTI | SWT.READ_ONLY | SWT.V_SCROLL | SWT.WRAP | SWT.BORDER);
      text.setText(page);
      text.setFont(JFaceResources.getTextFont());
      text.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
      return area;
    }

    @Override
    protected void createButtonsForButtonBar(Composite parent) {
      createButton(parent, IDialogConstants.OK_ID, IDialogConstants.CLOSE_LABEL, true);
    }
  }
}
