"""The panel's section of scenes: which one is played, and the ways to open and save one."""

from game.world.scenes.scene import scene_names


class SceneSection:
    """The list of scenes, and the buttons below it."""

    def __init__(self, sessions, commands):
        self._sessions, self._commands = sessions, commands
        self._names = scene_names()
        new = "An empty canvas of any size, or another size for this one"
        self._buttons = (
            ("Gallery", "F2", "All scenes at once, running, with a sentence about each", commands.show_scenes),
            ("New", "Ctrl+N", new, commands.new_canvas),
            ("Save", "Ctrl+S", "Saves all cells and settings in one picture", commands.save),
            ("Open", "Ctrl+O", "Shows the saved scenes; the one you open replaces this one", commands.open_scenes),
        )

    def lay_out(self, ui):
        """Show the section and do what it was told."""
        scene, commands = self._sessions.now.scene, self._commands
        names = self._names if scene.name in self._names else (*self._names, scene.name)
        titles = [self._sessions.title_of(name) for name in names]
        now = names.index(scene.name)
        chosen = ui.choice("Scene", titles, now, tip="Puts another scene in place of this one")
        if chosen != now:
            commands.open_shipped(names[chosen])
        if scene.notice:
            ui.text(scene.notice, dim=True)
        columns = 4 if ui.has_room_for("Gallery", 4) else 2
        for number, (label, key, tip, command) in enumerate(self._buttons):
            if number % columns == 0:
                ui.row(columns)
            if ui.button(label, key=key, tip=tip):
                command()
