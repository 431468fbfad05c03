package dev.eventchain.eclipse.ui;

import org.eclipse.ui.IFolderLayout;
import org.eclipse.ui.IPageLayout;
import org.eclipse.ui.IPerspectiveFactory;
import org.eclipse.ui.PlatformUI;

/**
 * A perspective with projects on the left, the editor above the problems, and the outline on the
 * right.
 */
public final class ChainPerspective implements IPerspectiveFactory {

  private static final String PROJECTS = "org.eclipse.ui.navigator.ProjectExplorer";
  private static final String CONSOLE = "org.eclipse.ui.console.ConsoleView";
  private static final String DIAGRAM = EventchainUi.ID + ".diagram";

  @Override
  public void createInitialLayout(IPageLayout layout) {
    String editor = layout.getEditorArea();
    layout.addView(PROJECTS, IPageLayout.LEFT, 0.22f, editor);
    IFolderLayout below = layout.createFolder("below", IPageLayout.BOTTOM, 0.65f, editor);
    below.addView(IPageLayout.ID_PROBLEM_VIEW);
    below.addView(CONSOLE);
    if (PlatformUI.getWorkbench().getViewRegistry().find(DIAGRAM) != null) {
      below.addView(DIAGRAM);
    }
    layout.addView(IPageLayout.ID_OUTLINE, IPageLayout.RIGHT, 0.75f, editor);
    layout.addNewWizardShortcut(EventchainUi.ID + ".wizards.project");
    layout.addShowViewShortcut(PROJECTS);
    layout.addShowViewShortcut(IPageLayout.ID_PROBLEM_VIEW);
    layout.addShowViewShortcut(CONSOLE);
    layout.addShowViewShortcut(IPageLayout.ID_OUTLINE);
    layout.addShowViewShortcut(DIAGRAM);
  }
}
