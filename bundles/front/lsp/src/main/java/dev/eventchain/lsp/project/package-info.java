/** Language service for the YAML and Markdown of projects: requirements, and who names them. */
package dev.eventchain.lsp.project;
