-- What people do with a document of rules in Neovim, with the client that Neovim brings along.
-- nvim --headless -u NONE -i NONE -n -S session.lua, with the server's start script in EVENTCHAIN_SCRIPT and the document in
-- EVENTCHAIN_FILE. Prints each answer; ends with 1 if one does not come.

vim.cmd("edit " .. vim.fn.fnameescape(vim.env.EVENTCHAIN_FILE))
local client = vim.lsp.start_client({
  name = "eventchain",
  cmd = { vim.env.EVENTCHAIN_SCRIPT, "lsp" },
  root_dir = vim.fn.fnamemodify(vim.env.EVENTCHAIN_FILE, ":h"),
})
vim.bo.filetype = "ocl"
vim.lsp.buf_attach_client(0, client)

local function wait(what, condition)
  if not vim.wait(60000, condition, 20) then
    print("never: " .. what .. "\n")
    vim.cmd("cquit")
  end
end

-- Puts the cursor on the last letter of a text's first occurrence.
local function go(text)
  for number, line in ipairs(vim.api.nvim_buf_get_lines(0, 0, -1, true)) do
    local _, last = line:find(text, 1, true)
    if last then
      vim.api.nvim_win_set_cursor(0, { number, last - 1 })
      return number, last
    end
  end
end

local function ask(method, column)
  local params = vim.lsp.util.make_position_params(0, "utf-16")
  params.position.character = params.position.character + (column or 0)
  for _, answer in pairs(vim.lsp.buf_request_sync(0, method, params, 60000) or {}) do
    return answer.result
  end
end

local function findings()
  local texts = {}
  for _, found in ipairs(vim.diagnostic.get(0)) do
    table.insert(texts, found.lnum + 1 .. ":" .. found.col + 1 .. " " .. found.message:gsub("\n.*", ""))
  end
  return table.concat(texts, "; ")
end

wait("findings", function() return #vim.diagnostic.get(0) > 0 end)
print("findings: " .. findings() .. "\n")

go("not self.isLong")
local hover = ask("textDocument/hover")
print("hover: " .. (hover and hover.contents.value or "nothing"):gsub("\n", " ") .. "\n")

go("not self.")
local proposals = ask("textDocument/completion", 1) or {}
local labels = {}
for _, item in ipairs(proposals.items or proposals) do
  labels[item.label:gsub("%(.*", "")] = true
end
print("completion: " .. tostring(labels.pages) .. " " .. tostring(labels.isLong) .. "\n")

go("not self.isLong")
vim.lsp.buf.definition()
wait("definition", function() return vim.api.nvim_win_get_cursor(0)[1] == 4 end)
print("definition: " .. vim.fn.expand("<cword>") .. "\n")

vim.lsp.buf.rename("isHuge")
wait("renaming", function() return vim.fn.getline(6):find("self.isHuge", 1, true) end)
print("renamed: " .. vim.trim(vim.fn.getline(4)) .. "\n")

vim.cmd("%s/titel/title/")
wait("no findings", function() return #vim.diagnostic.get(0) == 0 end)
print("no findings\n")

vim.lsp.stop_client(client)
wait("end", function() return vim.lsp.client_is_stopped(client) end)
print("all is well\n")
vim.cmd("qall!")
