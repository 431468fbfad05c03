/**
 * Formatting of files on behalf of commands and editors. Depends on the formatters of the languages
 * only.
 */
package dev.eventchain.pipeline.format;
